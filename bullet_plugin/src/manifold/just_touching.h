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

/// The distance of contacts that just touch, metres, or as much below zero as they are apart if that is less. Bullet's
/// solver leaves m_linearSlop over this of the gap open: PyBullet's 1e-5 is a small part, and 0.1 mm is to apps.
constexpr btScalar kJustTouching = btScalar(-1e-4);

/// Below zero, and without effect: an error reduction that ForgetTouching() takes back, or a soft contact's distance.
constexpr btScalar kBelowZero = btScalar(-1e-30);

/// Flags of how a point gives way: by numbers of its own, which an app or this file sets; or by these or its bodies'
/// stiffness and damping.
constexpr int kPointSoftness = BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP;
constexpr int kSoftness = BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING | kPointSoftness;
inline int SoftnessOf(const btManifoldPoint& point) { return point.m_contactPointFlags & kSoftness; }

/// Has a soft point that touches within the step give way for the rest of it: its spring acts from there on, by half of
/// what the bodies overlap at the end. Bullet's solver has it act all the step, by all of that.
/// @param rest  Seconds.
inline void SoftenImpact(btScalar rest, btManifoldPoint& point) {
  const btScalar stiffness = rest / 2 * point.m_combinedContactStiffness1 + point.m_combinedContactDamping1;
  point.m_contactCFM = 1 / btMax(stiffness, SIMD_EPSILON);
  point.m_contactERP = kBelowZero;
  point.m_contactPointFlags |= kPointSoftness;
}

/// Shows points of a pair's own manifold as touching, after callbacks have set their material.
/// @param was_loaded  Whether a point of the pair carried something in the last step.
/// @param motion      Motion of the manifold's bodies, in its order.
inline void ShowTouching(btPersistentManifold& manifold, bool was_loaded, const PairMotion& motion) {
  const auto near = btScalar(NegligibleDistance(double(manifold.getContactBreakingThreshold())));
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    const btScalar gap = point.m_distance1;
    const int softness = SoftnessOf(point);
    if (!(gap > 0) || (softness & kPointSoftness) != 0) continue;
    const Vector3 normal = -FromBullet(point.m_normalWorldOnB);
    const double speed =
        motion.ApproachSpeed(FromBullet(point.m_positionWorldOnA), FromBullet(point.m_positionWorldOnB), normal) +
        motion.ApproachSpeedGain(normal);
    const bool is_closed = double(gap) <= motion.TimeStep() * speed;
    if (softness != 0) {
      if (is_closed) SoftenImpact(btScalar(motion.TimeStep() - double(gap) / speed), point);
      continue;
    }
    if (!is_closed && !(was_loaded && gap <= near)) continue;
    DGD_ASSERT(std::isfinite(gap));
    point.m_distance1 = btMax(-gap, kJustTouching);
    point.m_contactERP = gap / point.m_distance1;
    point.m_contactPointFlags |= BT_CONTACT_FLAG_HAS_CONTACT_ERP;
  }
}

/// Takes back what points have for one step, marked by a negative error reduction: those that were shown as touching,
/// soft ones that touched, and those that their rebound does not push. Comes before anything else in a step.
inline void ForgetTouching(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.m_contactERP < 0) point.m_contactPointFlags &= ~kPointSoftness;
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
