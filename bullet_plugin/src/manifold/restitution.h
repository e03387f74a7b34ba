// Rebounds at the speed that the coefficient of restitution sets, at any time step.
//
// Bullet's constraint solver has bodies part at the coefficient times their speed of approach before the step's forces,
// and adds the gap or the overlap to that: bodies that are apart by s part slower by s / dt, and those that overlap by
// d faster by the world's error reduction times d / dt. So a contact that the step closes is handed over as just
// touching, and one that overlaps with an error reduction of its own, by which it is not pushed; with the coefficient
// that has bodies fly on as after an impact at the moment of touching.
//
// Between two steps, Bullet's integrator moves a body on a parabola through its places x_k, on which its speed at x_k
// is the mean of the stored one and the one after the next step's forces. With u the speed of approach, w what the
// forces add to it in the step, a = w / dt, and s the gap:
//
//   impact:      v^2 = (u + w/2)^2 + 2 a s
//   rebound:     (u' + w/2)^2 = e^2 v^2 - 2 a s,  u' the speed of parting that the solver is to leave
//
// Physics: for e = 1, u' = u, and energy is conserved exactly. The solver of multibodies begins with the speed that the
// forces have changed already, u + w.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "manifold/just_touching.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Speed of approach below which Bullet's solver lets bodies come to rest, metres per second (btContactSolverInfo's own
/// default).
constexpr double kSlowestRebound = 0.2;

/// The speed of parting after the impact, or nothing where the bodies do not rebound as far as they are apart now.
/// @param restitution     Coefficient, > 0.
/// @param approach, gain  u and w above, metres per second; u > 0.
/// @param gap             Metres, negative for overlap.
/// @param time_step       Seconds, > 0.
inline std::optional<double> SpeedAfterImpact(double restitution, double approach, double gain, double gap,
                                              double time_step) {
  DGD_ASSERT(restitution > 0 && time_step > 0);
  const double fall = 2 * gain / time_step * gap;
  const double mean = approach + gain / 2;
  const double after_sq = restitution * restitution * std::max(mean * mean + fall, 0.0) - fall;
  if (!(after_sq > 0)) return std::nullopt;
  const double after = std::sqrt(after_sq) - gain / 2;
  return after > 0 ? std::optional(after) : std::nullopt;
}

/// Prepares a point of a step's manifold for Bullet's solver, after callbacks have set its material.
/// @param motion  Motion of the manifold's bodies, in its order.
inline void PrepareRebound(btManifoldPoint& point, const PairMotion& motion) {
  const auto restitution = double(point.m_combinedRestitution);
  if (!(restitution > 0) || !motion.IsKnown()) return;
  const Vector3 normal = -FromBullet(point.m_normalWorldOnB);
  const double approach =
      motion.ApproachSpeed(FromBullet(point.m_positionWorldOnA), FromBullet(point.m_positionWorldOnB), normal);
  const double gain = motion.ApproachSpeedGain(normal);
  const double gap = double(point.getDistance()), time_step = motion.TimeStep();
  if (!(gap <= (approach + gain) * time_step)) return;
  if (!(approach > kSlowestRebound)) {
    // The solver of multibodies would take what the forces add for a speed of approach.
    if (motion.IsOfLinks()) point.m_combinedRestitution = 0;
    return;
  }
  const std::optional<double> after = SpeedAfterImpact(restitution, approach, gain, gap, time_step);
  const double approach_in_solver = motion.IsOfLinks() ? approach + gain : approach;
  if (!after || !(approach_in_solver > 0)) return;
  DGD_ASSERT(*after > 0);
  point.m_combinedRestitution = btScalar(*after / approach_in_solver);
  const bool is_soft = SoftnessOf(point) != 0;
  point.m_distance1 = btMin(point.m_distance1, is_soft ? kBelowZero : kJustTouching);
  if (is_soft) return;
  // Overlap is taken back by speed that bodies keep: not of those that part in any case.
  point.m_contactERP = kBelowZero;
  point.m_contactPointFlags |= BT_CONTACT_FLAG_HAS_CONTACT_ERP;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
