#include "mesh/face_contacts.h"

#include <cmath>
#include <exception>

#include "ahead/meeting.h"
#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "pair/pair_patch.h"
#include "pair/pair_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Cosine of the last normal to a triangle's own above which the last one shows on which side of the triangle a body
/// is: within 6 degrees of the triangle's plane, the side would be chance.
constexpr double kMinFacing = 0.1;

/// The faces that the shapes show each other along result.normal.
dgd::FacingFaces<double> FindFacing(const PosedShape& shape, const PosedShape& triangle, const Contact& result) {
  dgd::FacingFaces<double> facing;
  dgd::FindFacingFaces(shape.set, shape.pose, triangle.set, triangle.pose, result, facing);
  if (facing.face_1.size == 0) {
    // A shape that shows no faces touches at its farthest point.
    facing.face_1.Add(facing.frame.FromWorld(result.witness_1));
    facing.FindOverlap();
  }
  return facing;
}

/// Whether a triangle's normal is from the body to the triangle: by the pair's last normal, or by the body's centre
/// where that is along the triangle.
bool IsTowards(const Vector3& normal, const PosedShape& convex, const PosedShape& triangle, const PairCache& cache) {
  if (cache.HasNormal()) {
    // A body's centre may be behind the plane of a triangle that it is next to.
    const Vector3 last = cache.IsSwapped() ? Vector3(-(triangle.pose.rotation * cache.NormalInA()))
                                           : Vector3(convex.pose.rotation * cache.NormalInA());
    const double cosine = normal.dot(last);
    if (std::abs(cosine) > kMinFacing) return cosine > 0;
  }
  return normal.dot(CenterOf(triangle) - CenterOf(convex)) > 0;
}

/// The contacts of a pair where it has been moved to, moved back to the step's beginning.
FaceContacts FindFaceContacts(const MovingPair& pair, const Vector3& normal, const Moment& moment,
                              const PatchRules& rules) {
  DGD_ASSERT(IsUnit(normal) && !(rules.flush < 0));
  Contact contact;
  contact.normal = normal;
  contact.witness_1 = SupportPoint(pair.a(), normal);
  contact.separation = normal.dot(SupportPoint(pair.b(), -normal) - contact.witness_1);
  contact.witness_2 = contact.witness_1 + contact.separation * normal;
  const dgd::FacingFaces<double> facing = FindFacing(pair.a(), pair.b(), contact);
  const dgd::Corner<double>* nearest = facing.Nearest();
  if (nearest == nullptr) return {};
  contact.separation = nearest->Separation();
  if (!moment.is_impact && contact.separation > rules.range.touching) return {};
  FaceContacts contacts{FindPatch(contact, facing, rules, moment), normal};
  pair.MoveToStart(normal, rules.flush, contacts.patch);
  return contacts;
}

}  // namespace

FaceContacts FindTriangleFaceContacts(SharedState& narrowphase, PairCache& cache, const PairBodies& convex_and_triangle,
                                      const Vector3& normal, const Moment& moment, const TriangleQuery& query) try {
  DGD_ASSERT(IsUnit(normal));
  PairCache::Hull no_hull;
  PairCache::Hull& hull = cache.IsSwapped() ? cache.hull_b() : cache.hull_a();
  const bool for_user = query.limits.is_user_query;
  const PosedShape convex = AdaptBody(narrowphase, convex_and_triangle.first, hull, for_user);
  const PosedShape triangle = AdaptBody(narrowphase, convex_and_triangle.second, no_hull, for_user);
  // The side is that of now: where they meet, a body that reaches a triangle from outside of it may be on the other.
  const Vector3 towards = IsTowards(normal, convex, triangle, cache) ? normal : Vector3(-normal);
  MovingPair pair(convex, triangle, query.motion);
  pair.MoveTo(moment.time);
  const PatchRules rules{query.limits.range, query.limits.patch_settings, query.motion, query.flush};
  return FindFaceContacts(pair, towards, moment, rules);
} catch (const std::exception&) {
  return {};  // FindTriangleContacts() has counted it.
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
