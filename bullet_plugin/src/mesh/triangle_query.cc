#include "mesh/triangle_query.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>
#include <cmath>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "pair/pair_patch.h"
#include "pair/separating_axis.h"
#include "pair/shared_stages.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Cosine of the last normal to a triangle's own above which the last one shows on which side of the triangle a body
/// is: within 6 degrees of the triangle's plane, the side would be chance.
constexpr double kMinFacing = 0.1;

dgd::AnySet TriangleOf(const MeshTriangle& triangle, double margin) {
  const auto corner = [&](std::size_t i) { return FromBullet(triangle.corners[i]); };
  return dgd::RoundedSet{dgd::Triangle<double>(corner(0), corner(1), corner(2)), margin};
}

}  // namespace

TriangleQuery::TriangleQuery(SharedState& narrowphase, const PairBodies& convex_and_mesh, const MeshQuery& query,
                             PairCache::Hull& hull)
    : options_(narrowphase.options()),
      query_(query),
      limits_(query.limits),
      mesh_(FromBullet(convex_and_mesh.second.getWorldTransform())),
      margin_(options_.geometry_mode == GeometryMode::kSharp
                  ? 0
                  : double(convex_and_mesh.second.getCollisionShape()->getMargin())),
      convex_(AdaptBody(narrowphase, convex_and_mesh.first, hull, query.limits.is_user_query)),
      center_(CenterOf(convex_)),
      inradius_(convex_.set.CoreInradius() + convex_.set.Radius()),
      triangle_{TriangleOf({}, dgd::RequireLength(margin_, true, "collision margin")), mesh_} {}

void TriangleQuery::Place(const MeshTriangle& triangle, const Vector3& normal) {
  triangle_.set = TriangleOf(triangle, margin_);
  limits_.triangle_normal = normal;
}

bool TriangleQuery::IsApartAlong(const Vector3& normal, const Vector3& on_triangle, double distance) const {
  const double separation = normal.dot(on_triangle - SupportPoint(convex_, normal));
  return separation > distance && !query_.motion.MayApproachBy(separation, normal);
}

bool TriangleQuery::IsOutOfPlane(const MeshTriangle& triangle, const Vector3& normal) const {
  if (normal.isZero(0)) return false;
  const Vector3 corner = mesh_ * FromBullet(triangle.corners[0]);
  const double height = normal.dot(center_ - corner);
  // Mostly without the support function.
  if (std::abs(height) <= inradius_ + margin_ + limits_.range.touching) return false;
  const Vector3 towards = height > 0 ? Vector3(-normal) : normal;
  return IsApartAlong(towards, corner - margin_ * towards, limits_.range.touching);
}

PairOutcome TriangleQuery::FindContacts(TriangleState& state, PairContacts& contacts) {
  contacts.patch.size = 0;
  contacts.moment = {};
  if (!options_.warm_start) state = {};
  const Vector3 last = convex_.pose.rotation * state.warm_start.normal_1;
  if (!state.had_contact && dgd::HasNormal(state.warm_start) &&
      IsApartAlong(last, SupportPoint(triangle_, -last), std::max(limits_.range.touching, 0.0))) {
    return kApart;
  }
  state.had_contact = false;
  PairQuery query(options_, convex_, triangle_, limits_, query_.flush, query_.motion, state.warm_start);
  const PairOutcome outcome = query.FindContacts(contacts);
  state.had_contact = contacts.patch.size > 0;
  state.moment = contacts.moment;
  return outcome;
}

bool TriangleQuery::IsTowards(const TriangleState& state) const {
  const Vector3& normal = limits_.triangle_normal;
  if (dgd::HasNormal(state.warm_start)) {
    // A body's centre may be behind the plane of a triangle that it is next to.
    const double cosine = normal.dot(convex_.pose.rotation * state.warm_start.normal_1);
    if (std::abs(cosine) > kMinFacing) return cosine > 0;
  }
  return normal.dot(CenterOf(triangle_) - center_) > 0;
}

void TriangleQuery::FindFaceContacts(const TriangleState& state, PairContacts& contacts) const {
  DGD_ASSERT(IsUnit(limits_.triangle_normal));
  contacts.patch.size = 0;
  // The side is that of now: where they meet, a body that reaches a triangle from outside of it may be on the other.
  contacts.normal = IsTowards(state) ? limits_.triangle_normal : Vector3(-limits_.triangle_normal);
  MovingPair pair(convex_, triangle_, query_.motion);
  pair.MoveTo(state.moment.time);
  Contact contact;
  contact.normal = contacts.normal;
  contact.witness_1 = SupportPoint(pair.a(), contact.normal);
  contact.separation = contact.normal.dot(SupportPoint(pair.b(), -contact.normal) - contact.witness_1);
  contact.witness_2 = contact.witness_1 + contact.separation * contact.normal;
  dgd::FacingFaces<double> facing;
  dgd::FindFacingFaces(pair.a().set, pair.a().pose, pair.b().set, pair.b().pose, contact, facing);
  if (facing.face_1.size == 0) {
    // A shape that shows no faces touches at its farthest point.
    facing.face_1.Add(facing.frame.FromWorld(contact.witness_1));
    facing.FindOverlap();
  }
  const dgd::Corner<double>* nearest = facing.Nearest();
  if (nearest == nullptr) return;
  contact.separation = nearest->Separation();
  if (!state.moment.is_impact && contact.separation > limits_.range.touching) return;
  const PatchRules rules{limits_.range, limits_.patch_settings, query_.motion, query_.flush};
  contacts.patch = FindPatch(contact, facing, rules, state.moment);
  pair.MoveToStart(contact.normal, rules.flush, contacts.patch);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
