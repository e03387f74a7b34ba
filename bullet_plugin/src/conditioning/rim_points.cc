#include "conditioning/rim_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Whether bodies turn against each other on a face that has more corners than the patch may have, a disc or a polygon
/// nearly as round. What rolls on its side shows no such face.
bool MayWobble(const dgd::ContactPatch<double>& patch, const dgd::SupportingFace<double>& face,
               const dgd::PatchSettings<double>& settings, const PairMotion& motion) {
  return patch.size > 0 && settings.max_points > 1 && face.size > settings.max_points && !motion.Turn().isZero(0);
}

/// The point of the shape, where it is now, that will be its farthest one along a direction once it has turned; world.
/// @param turn  Radians times the axis, world.
Vector3 SupportPointOnceTurned(const PosedShape& shape, const Vector3& direction, const Vector3& turn) {
  DGD_ASSERT(IsUnit(direction));
  const double angle = turn.norm();
  const Vector3 before = angle > 0 ? Vector3(Eigen::AngleAxisd(-angle, turn / angle) * direction) : direction;
  const Vector3 local = shape.pose.rotation.transpose() * before;
  return shape.pose * shape.set.CoreSupport(local) + shape.set.Radius() * direction;
}

/// Adds a point if it will overlap at the end of the step, or be deeper, by more than bodies at rest move.
void AddComing(const dgd::ContactPoint<double>& coming, const Vector3& normal,
               const dgd::PatchSettings<double>& settings, const PairMotion& motion, dgd::ContactPatch<double>& patch) {
  if (!(motion.Approach(coming.on_1, normal) > std::max(coming.separation, 0.0) + settings.equal_depth)) return;
  const double spacing_sq = settings.spacing * settings.spacing;
  for (int i = 0; i < patch.size; ++i) {
    const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    if (!((point.on_1 - coming.on_1).squaredNorm() > spacing_sq)) return;
  }
  if (patch.size == settings.max_points) --patch.size;
  DGD_ASSERT(patch.size < dgd::ContactPatch<double>::kMaxPoints);
  patch.points[static_cast<std::size_t>(patch.size++)] = coming;
}

}  // namespace

void AddRimPoint(const PosedShape& shape_a, const PosedShape& shape_b, const Contact& contact,
                 const dgd::FacingFaces<double>& facing, const dgd::PatchSettings<double>& settings,
                 const PairMotion& motion, dgd::ContactPatch<double>& patch) {
  const Vector3& normal = contact.normal;
  const bool is_a = facing.is_across_2 && MayWobble(patch, facing.face_1, settings, motion);
  if (!is_a && !(facing.is_across_1 && MayWobble(patch, facing.face_2, settings, motion))) return;
  const Vector3 rim = is_a ? SupportPointOnceTurned(shape_a, normal, motion.Turn())
                           : SupportPointOnceTurned(shape_b, -normal, -motion.Turn());
  const std::optional<dgd::Corner<double>> corner = facing.CornerAt(facing.frame.FromWorld(rim), is_a);
  if (!corner) return;
  DGD_ASSERT(IsUnit(normal) && facing.overlap.size > 0);
  const double separation = corner->Separation();
  const Vector3 on_1 = is_a ? rim : Vector3(rim - separation * normal);
  AddComing({on_1, on_1 + separation * normal, separation}, normal, settings, motion, patch);
}

void AddRimPointOnPlane(const PosedShape& shape, const Contact& contact, const dgd::FacingFaces<double>& facing,
                        const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                        dgd::ContactPatch<double>& patch) {
  const Vector3& normal = contact.normal;
  if (!MayWobble(patch, facing.face_1, settings, motion)) return;
  const Vector3 rim = SupportPointOnceTurned(shape, normal, motion.Turn());
  const double separation = normal.dot(contact.witness_2 - rim);
  AddComing({rim, rim + separation * normal, separation}, normal, settings, motion, patch);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
