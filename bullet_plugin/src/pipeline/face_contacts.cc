#include "pipeline/face_contacts.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "conditioning/speculative_contacts.h"
#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "pipeline/pair_patch.h"
#include "pipeline/pair_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Cosine of the last normal to a triangle's own above which the last one shows on which side of the triangle a body
/// is: within 6 degrees of the triangle's plane, the side would be chance.
constexpr double kMinFacing = 0.1;

/// A body that moves past a triangle reaches its plane with one part after another: at most so many are tried.
constexpr int kMaxParts = 4;

/// The faces that the shapes show each other along result.normal.
dgd::FacingFaces<double> FindFacing(const PosedShape& shape, const PosedShape& triangle, const Contact& result,
                                    double angular_tolerance) {
  dgd::FacingFaces<double> facing;
  dgd::FindFacingFaces(shape.set, shape.pose, triangle.set, triangle.pose, result, angular_tolerance, facing);
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

/// Whether a triangle's normal is from the body to the triangle: by the pair's last normal, or by the body's centre
/// where that is along the triangle.
bool IsTowards(const Vector3& normal, const PosedShape& convex, const PosedShape& triangle, const PairCache& cache) {
  if (cache.HasNormal()) {
    // Most of a body may be behind the plane of a triangle that it is next to.
    const Vector3 last = cache.IsSwapped() ? Vector3(-(triangle.pose.rotation * cache.NormalInA()))
                                           : Vector3(convex.pose.rotation * cache.NormalInA());
    const double cosine = normal.dot(last);
    if (std::abs(cosine) > kMinFacing) return cosine > 0;
  }
  return normal.dot(CenterOf(triangle) - CenterOf(convex)) > 0;
}

}  // namespace

FaceContacts FindFaceContacts(PosedShape shape, const PosedShape& triangle, const Vector3& normal,
                              const TriangleQuery& query) {
  DGD_ASSERT(IsUnit(normal) && !(query.flush < 0));
  const PairMotion& motion = query.motion;
  const Vector3 deepest = SupportPoint(shape, normal), start = shape.pose.translation;
  Contact result;
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
    if (parts == kMaxParts || !(approach >= separation)) return {};
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

FaceContacts FindTriangleFaceContacts(Narrowphase& narrowphase, PairCache& cache, const PairBodies& convex_and_triangle,
                                      const Vector3& normal, const TriangleQuery& query) try {
  DGD_ASSERT(IsUnit(normal));
  PairCache::Hull no_hull;
  PairCache::Hull& hull = cache.IsSwapped() ? cache.hull_b() : cache.hull_a();
  const PosedShape convex = AdaptBody(narrowphase, convex_and_triangle.first, hull, query.is_user_query);
  const PosedShape triangle = AdaptBody(narrowphase, convex_and_triangle.second, no_hull, query.is_user_query);
  return FindFaceContacts(convex, triangle, IsTowards(normal, convex, triangle, cache) ? normal : Vector3(-normal),
                          query);
} catch (const std::exception&) {
  return {};  // FindTriangleContacts() has counted it.
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
