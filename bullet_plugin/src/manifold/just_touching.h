// The distance that apps read of bodies that touch: just below zero.
//
// Apps take the sign of a contact's distance for whether two bodies touch. Bullet's own narrowphase meets bodies once
// they overlap; here a body is met ahead of touching, and rests as far from its support as roundoff leaves it. So a
// contact that this step closes, and a near one that carried something in the last step, is shown as just touching. The
// solver still gets the gap: an overlap times the point's error reduction, which is negative here, is a negative push.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "lengths.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The distance of contacts that just touch, metres: what Bullet's solver makes of this overlap is below roundoff.
constexpr btScalar kJustTouching = btScalar(-1e-9);

/// Whether an app, or its material, has set how a point gives way.
inline bool HasOwnSoftness(const btManifoldPoint& point) {
  constexpr int kSoftness =
      BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP | BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING;
  return (point.m_contactPointFlags & kSoftness) != 0;
}

/// Shows points of a pair's own manifold as touching, after callbacks have set their material.
/// @param was_loaded  Whether a point of the pair carried something in the last step.
/// @param motion      Motion of the manifold's bodies, in its order.
inline void ShowTouching(btPersistentManifold& manifold, bool was_loaded, const PairMotion& motion) {
  const auto near = btScalar(NegligibleDistance(double(manifold.getContactBreakingThreshold())));
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    const btScalar gap = point.m_distance1;
    if (!(gap > 0) || HasOwnSoftness(point)) continue;
    const Vector3 normal = -FromBullet(point.m_normalWorldOnB);
    const double speed =
        motion.ApproachSpeed(FromBullet(point.m_positionWorldOnA), FromBullet(point.m_positionWorldOnB), normal) +
        motion.ApproachSpeedGain(normal);
    const bool touches = (was_loaded && gap <= near) || double(gap) <= motion.TimeStep() * speed;
    if (!touches) continue;
    DGD_ASSERT(std::isfinite(gap));
    point.m_contactERP = gap / kJustTouching;
    point.m_contactPointFlags |= BT_CONTACT_FLAG_HAS_CONTACT_ERP;
    point.m_distance1 = kJustTouching;
  }
}

/// Takes back the error reduction of points that were shown as touching, or are not pushed by their rebound: it is for
/// one step. Comes before anything else in a step.
inline void ForgetTouching(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.m_contactERP < 0) point.m_contactPointFlags &= ~BT_CONTACT_FLAG_HAS_CONTACT_ERP;
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
