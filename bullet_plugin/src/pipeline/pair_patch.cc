#include "pipeline/pair_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Of the step: where a body that is in contact comes down on another of its corners, that carries it from the
/// beginning of the step or, met later than this, of the next one. Whichever is nearer: always the one before would
/// take energy from what rocks (tests/physics, rocking at 240 Hz: 0.12 in place of 0.09).
constexpr double kSoon = 0.5;

/// Whether another point may come to a patch: where bodies turn against each other on a face that has more corners than
/// the patch may have, a disc or a polygon nearly as round. What rolls on its side shows no such face.
bool MayCome(const dgd::ContactPatch<double>& patch, const dgd::SupportingFace<double>& face,
             const dgd::PatchSettings<double>& settings, const PairMotion& motion) {
  return patch.size > 0 && settings.max_points > 1 && face.size > settings.max_points && !motion.Turn().isZero(0);
}

/// The point of the shape, where it is now, that will be its farthest one along a direction once it has turned; world.
/// @param turn  Radians times the axis, world.
Vector3 FarthestOnceTurned(const PosedShape& shape, const Vector3& direction, const Vector3& turn) {
  const double angle = turn.norm();
  const Vector3 seen = angle > 0 ? Vector3(Eigen::AngleAxisd(-angle, turn / angle) * direction) : direction;
  const Vector3 local = shape.pose.rotation.transpose() * seen;
  return shape.pose * shape.set.CoreSupport(local) + shape.set.Radius() * direction;
}

/// If it will be in overlap at the end of the step, or deeper, by more than bodies at rest move.
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

void FindFacingFaces(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     double angular_tolerance, dgd::FacingFaces<double>& facing) {
  dgd::FindFacingFaces(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, result, angular_tolerance, facing);
}

dgd::ContactPatch<double> FindPatch(const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion) {
  // Most often not, and then no corner's own speed is looked at.
  const bool may_meet = motion.MayApproachBy(settings.equal_depth, result.normal);
  if (!may_meet) return dgd::FindContactPatch(result, facing, settings, [](const Vector3&, double) { return false; });
  dgd::PatchSettings<double> touching = settings;
  touching.contact_distance = std::min(settings.contact_distance, settings.equal_depth);
  const bool is_in_touch = result.separation <= touching.contact_distance;
  const auto counts = [&](const Vector3& point, double separation) {
    const double approach = motion.Approach(point, result.normal);
    if (approach < separation) return separation <= settings.contact_distance;
    return !is_in_touch || separation <= kSoon * approach;
  };
  return dgd::FindContactPatch(result, facing, touching, counts);
}

void AddRimPoint(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                 const dgd::FacingFaces<double>& facing, const dgd::PatchSettings<double>& settings,
                 const PairMotion& motion, dgd::ContactPatch<double>& patch) {
  const Vector3& normal = result.normal;
  const bool is_a = facing.is_across_2 && MayCome(patch, facing.face_1, settings, motion);
  if (!is_a && !(facing.is_across_1 && MayCome(patch, facing.face_2, settings, motion))) return;
  const Vector3 rim =
      is_a ? FarthestOnceTurned(shape_a, normal, motion.Turn()) : FarthestOnceTurned(shape_b, -normal, -motion.Turn());
  const std::optional<dgd::Corner<double>> corner = facing.CornerAt(facing.frame.FromWorld(rim), is_a);
  if (!corner) return;
  const double separation = corner->Separation();
  const Vector3 on_1 = is_a ? rim : Vector3(rim - separation * normal);
  AddComing({on_1, on_1 + separation * normal, separation}, normal, settings, motion, patch);
}

void AddRimPoint(const PosedShape& shape, const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                 const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                 dgd::ContactPatch<double>& patch) {
  const Vector3& normal = result.normal;
  if (!MayCome(patch, facing.face_1, settings, motion)) return;
  const Vector3 rim = FarthestOnceTurned(shape, normal, motion.Turn());
  const double separation = normal.dot(result.witness_2 - rim);
  AddComing({rim, rim + separation * normal, separation}, normal, settings, motion, patch);
}

dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result) {
  const Vector3 middle = (result.witness_1 + result.witness_2) / 2;
  dgd::ContactPatch<double> patch;
  patch.size = 1;
  patch.points[0] = {middle - result.separation / 2 * result.normal, middle + result.separation / 2 * result.normal,
                     result.separation};
  return patch;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
