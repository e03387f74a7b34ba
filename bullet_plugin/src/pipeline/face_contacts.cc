#include "pipeline/face_contacts.h"

#include <algorithm>

#include "conditioning/speculative_contacts.h"
#include "dgd/facing_faces.h"
#include "pipeline/pair_patch.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// A body that moves past a triangle reaches its plane with one part after another: at most so many are followed.
constexpr int kMostParts = 4;

/// What the shapes show each other along result.normal.
dgd::FacingFaces<double> FindFacing(const PosedShape& shape, const PosedShape& triangle,
                                    const dgd::Result<double>& result, double angular_tolerance) {
  dgd::FacingFaces<double> facing;
  FindFacingFaces(shape, triangle, result, angular_tolerance, facing);
  if (facing.face_1.size == 0) {
    // A shape that shows no faces touches at its farthest point.
    facing.face_1.Add(facing.frame.FromWorld(result.witness_1));
    facing.FindOverlap(angular_tolerance);
  }
  return facing;
}

/// Metres that the body moves across the normal while it comes nearer along it by one metre.
Vector3 WayAcross(const PairMotion& motion, const Vector3& point, const Vector3& normal) {
  Vector3 way;
  for (int axis = 0; axis < 3; ++axis) way[axis] = motion.Approach(point, Vector3::Unit(axis));
  const double along = normal.dot(way);
  return (way - along * normal) / along;
}

}  // namespace

FaceContacts FindFaceContacts(PosedShape shape, const PosedShape& triangle, const Vector3& normal,
                              const TriangleQuery& query) {
  const PairMotion& motion = query.motion;
  const Vector3 deepest = SupportPoint(shape, normal), start = shape.pose.translation;
  dgd::Result<double> result;
  result.normal = normal;
  result.separation = normal.dot(SupportPoint(triangle, -normal) - deepest);
  const double approach = motion.Approach(deepest, normal);
  const bool is_ahead = result.separation > std::max(query.range.touching, 0.0);
  if (is_ahead && (result.separation > query.range.limit || !(approach >= result.separation))) return {};
  if (result.separation > query.flush && TurnsClear(shape, triangle, motion, normal, query.flush)) return {};
  const Vector3 way_across = is_ahead ? WayAcross(motion, deepest, normal) : Vector3(Vector3::Zero());

  // Moved to where its deepest part meets the plane, the body may show the triangle another part, which meets it later.
  Vector3 shift;
  dgd::FacingFaces<double> facing;
  for (int parts = 1;; ++parts) {
    shift = result.separation * way_across;
    shape.pose.translation = start + shift;
    result.witness_1 = deepest + shift;
    result.witness_2 = result.witness_1 + result.separation * normal;
    facing = FindFacing(shape, triangle, result, query.angular_tolerance);
    const dgd::Corner<double>* nearest = facing.Nearest();
    if (nearest == nullptr) return {};
    const double separation = nearest->Separation();
    const bool is_same_part = !is_ahead || separation <= result.separation + query.flush;
    result.separation = separation;
    if (is_same_part) break;
    if (parts == kMostParts || !(approach >= separation)) return {};
  }
  FaceContacts contacts{FindPatch(result, facing, query.patch_settings, motion), normal, shift};
  dgd::ContactPatch<double>& patch = contacts.patch;
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    point.on_1 -= shift;
    point.on_2 -= shift;
  }
  return contacts;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
