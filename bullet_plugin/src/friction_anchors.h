// Contacts that stick are held where they first stuck.
//
// Bullet's solver knows friction as a wish for no speed. What speed its iterations leave in a step is never taken back:
// piles creep by millimetres a minute. Its friction anchors (btCollisionObject::CF_HAS_FRICTION_ANCHOR) make the solver
// take back the way as well, but keep a contact point with its old normal and place for as long as it sticks, so that a
// wheel is held by where it stood. Here each step's patch counts, and an anchor is only what two points that once met
// have slipped since: a rolling body slips by nothing.
//
// All inline: these are asked of every point in every step.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

namespace dgd_bullet {

/// On fewer points bodies rock, and would be given back what they slipped: fifty polytopes come to rest a tenth later.
constexpr int kFewestAnchors = 3;

/// Of the breaking threshold: a body that slips by more has slid. By measurement (contact_report, float, no resting
/// contacts kept): with this scenes/pyramid_28.json creeps by 1.3 mm in a minute, with a tenth of it by 25 mm.
constexpr btScalar kMaxSlip = btScalar(0.01);

/// Whether a point's lateral impulses were within the friction cone.
inline bool Sticks(const btManifoldPoint& point) {
  const btScalar lateral_1 = point.m_appliedImpulseLateral1, lateral_2 = point.m_appliedImpulseLateral2;
  const btScalar cone = point.m_combinedFriction * point.m_appliedImpulse;
  return lateral_1 * lateral_1 + lateral_2 * lateral_2 < cone * cone;
}

/// Whether a point that has been in its manifold for a step stuck there.
inline bool IsStuck(const btManifoldPoint& point) { return point.getLifeTime() > 0 && Sticks(point); }

/// Neither anchored by Bullet itself, nor on surfaces with a motion of their own, such as belts.
inline bool CanBeAnchored(const btManifoldPoint& point) {
  // Contact flags are bits of an integer in Bullet.
  constexpr int kNotOurs = BT_CONTACT_FLAG_FRICTION_ANCHOR | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  return (point.m_contactPointFlags & kNotOurs) == 0;
}

/// The way that the surfaces have slipped by, since the point's two places met, across a normal: B to A, world, metres;
/// up to a small part of the breaking threshold.
inline btVector3 SlipOf(const btManifoldPoint& point, const btTransform& pose_a, const btTransform& pose_b,
                        const btVector3& normal, btScalar breaking_threshold) {
  btVector3 slip = pose_a(point.m_localPointA) - pose_b(point.m_localPointB);
  slip -= slip.dot(normal) * normal;
  const btScalar max_slip = kMaxSlip * breaking_threshold;
  const btScalar length_sq = slip.length2();
  if (!(length_sq < btScalar(SIMD_INFINITY))) return {0, 0, 0};
  if (length_sq > max_slip * max_slip) slip *= max_slip / btSqrt(length_sq);
  return slip;
}

/// Has the solver take back the slip of a point that has just been found anew: moves its two places, if it can be
/// anchored.
inline void Hold(btManifoldPoint& point, const btVector3& slip, const btTransform& pose_a, const btTransform& pose_b) {
  if (!CanBeAnchored(point)) return;
  const btVector3 half = btScalar(0.5) * slip;
  point.m_positionWorldOnA += half;
  point.m_positionWorldOnB -= half;
  point.m_localPointA += half * pose_a.getBasis();
  point.m_localPointB -= half * pose_b.getBasis();
  point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
}

/// For a manifold whose points have been kept, not found anew, of bodies that Bullet itself anchors nothing on: those
/// that stuck in the last step are held where they were found, and no others.
inline void HoldKept(btPersistentManifold& manifold) {
  if (manifold.getNumContacts() < kFewestAnchors) return;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    point.m_contactPointFlags &= ~BT_CONTACT_FLAG_FRICTION_ANCHOR;
    if (CanBeAnchored(point) && Sticks(point)) point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
  }
}

}  // namespace dgd_bullet
