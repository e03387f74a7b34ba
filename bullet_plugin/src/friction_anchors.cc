#include "friction_anchors.h"

namespace dgd_bullet {
namespace {

/// Of the breaking threshold: a body that slips by more has slid. By measurement (contact_report, float, no resting
/// contacts kept): with this scenes/pyramid_28.json creeps by 1.3 mm in a minute, with a tenth of it by 25 mm.
constexpr btScalar kMaxSlip = btScalar(0.01);

/// Contact flags are bits of an integer in Bullet.
constexpr int kAnchored = BT_CONTACT_FLAG_FRICTION_ANCHOR;
constexpr int kNotOurs = kAnchored | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;

bool IsOurs(const btManifoldPoint& point) { return (point.m_contactPointFlags & kNotOurs) == 0; }

bool Sticks(const btManifoldPoint& point) {
  const btScalar lateral_1 = point.m_appliedImpulseLateral1, lateral_2 = point.m_appliedImpulseLateral2;
  const btScalar cone = point.m_combinedFriction * point.m_appliedImpulse;
  return lateral_1 * lateral_1 + lateral_2 * lateral_2 < cone * cone;
}

}  // namespace

bool IsStuck(const btManifoldPoint& point) { return point.getLifeTime() > 0 && Sticks(point); }

btVector3 SlipOf(const btManifoldPoint& point, const btTransform& pose_a, const btTransform& pose_b,
                 const btVector3& normal, btScalar breaking_threshold) {
  btVector3 slip = pose_a(point.m_localPointA) - pose_b(point.m_localPointB);
  slip -= slip.dot(normal) * normal;
  const btScalar max_slip = kMaxSlip * breaking_threshold;
  const btScalar length_sq = slip.length2();
  if (!(length_sq < btScalar(SIMD_INFINITY))) return {0, 0, 0};
  if (length_sq > max_slip * max_slip) slip *= max_slip / btSqrt(length_sq);
  return slip;
}

void Hold(btManifoldPoint& point, const btVector3& slip, const btTransform& pose_a, const btTransform& pose_b) {
  if (!IsOurs(point)) return;
  const btVector3 half = btScalar(0.5) * slip;
  point.m_positionWorldOnA += half;
  point.m_positionWorldOnB -= half;
  point.m_localPointA += half * pose_a.getBasis();
  point.m_localPointB -= half * pose_b.getBasis();
  point.m_contactPointFlags |= kAnchored;
}

void HoldKept(btPersistentManifold& manifold) {
  if (manifold.getNumContacts() < kFewestAnchors) return;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (IsOurs(point) && Sticks(point)) point.m_contactPointFlags |= kAnchored;
  }
}

}  // namespace dgd_bullet
