// Contacts that stick are held where they stuck.
//
// Bullet's solver knows friction as a wish for no speed. What speed its iterations leave in a step is never taken back:
// piles creep by millimetres a minute. Its friction anchors (btCollisionObject::CF_HAS_FRICTION_ANCHOR) make the solver
// take back the way as well, but keep a contact point with its old normal and place for as long as it sticks, so that a
// wheel is held by where it stood. Here each step's patch counts, and an anchor holds only the slip that the solver has
// left: the way by which the two places of a contact that has stuck for two steps or more have moved apart as their
// bodies' velocities say. A body that rolls slips by nothing. What slides is not held, nor what an app moves: surfaces
// with a velocity of their own, bodies that it puts elsewhere or pushes between two steps.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

#include <limits>

#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/body_velocity.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// On fewer points bodies rock, and would be given back what they slipped: fifty polytopes come to rest a tenth later.
constexpr int kFewestAnchors = 3;

/// Whether a point's lateral impulses were within the friction cone.
inline bool Sticks(const btManifoldPoint& point) {
  const btScalar lateral_1 = point.m_appliedImpulseLateral1, lateral_2 = point.m_appliedImpulseLateral2;
  const btScalar cone = point.m_combinedFriction * point.m_appliedImpulse;
  return lateral_1 * lateral_1 + lateral_2 * lateral_2 < cone * cone;
}

/// Whether no callback moves the surface at a point, as of belts.
inline bool CanBeAnchored(const btManifoldPoint& point) {
  return (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED) == 0;
}

/// The anchors of a manifold's points, from one step to the next. Whether a point stuck, its places and its anchor are
/// those of the last step.
class FrictionAnchors {
 public:
  /// @param manifold   The pair's own, of bodies that Bullet itself anchors nothing on.
  /// @param time_step  Seconds; 0 to hold nothing.
  FrictionAnchors(const btPersistentManifold& manifold, btScalar time_step)
      : a_(*manifold.getBody0()), b_(*manifold.getBody1()), time_step_(time_step) {
    max_slip_ = kMaxSlip * manifold.getContactBreakingThreshold();
    can_hold_ = time_step > 0 && !a_.is_moved_by_app && !b_.is_moved_by_app;
    if (!can_hold_) return;
    const btScalar farthest =
        btMax(a_.pose.getOrigin().absolute().dot({1, 1, 1}), b_.pose.getOrigin().absolute().dot({1, 1, 1}));
    roundoff_ = kRoundings * std::numeric_limits<btScalar>::epsilon() * farthest;
    can_hold_ = roundoff_ <= kMostRoundoff * max_slip_;
    turning_ = a_.velocity.angular - b_.velocity.angular;
    linear_at_a_ =
        a_.velocity.linear - b_.velocity.linear - b_.velocity.angular.cross(a_.pose.getOrigin() - b_.pose.getOrigin());
  }

  /// Whether a point may be held from this step on.
  bool CanHold(const btManifoldPoint& point) const {
    return can_hold_ && point.getLifeTime() > 0 && Sticks(point) && CanBeAnchored(point);
  }

  /// What the solver has left of slip at a point that can be held, as long as it has been: B to A, across the normal,
  /// world, metres; nothing if that is not all that has moved its places apart.
  btVector3 SlipOf(const btManifoldPoint& point) const {
    return SlipOf(point, a_.pose(point.m_localPointA), b_.pose(point.m_localPointB));
  }

  /// Has the solver take back the slip of a point that has just been placed without any.
  void Hold(btManifoldPoint& point, const btVector3& slip) const {
    DGD_ASSERT(slip.length2() <= btScalar(1.01) * max_slip_ * max_slip_);
    if (!CanBeAnchored(point)) return;  // By this step's callback.
    const btVector3 half = btScalar(0.5) * slip;
    point.m_positionWorldOnA += half;
    point.m_positionWorldOnB -= half;
    point.m_localPointA += half * a_.pose.getBasis();
    point.m_localPointB -= half * b_.pose.getBasis();
    point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
  }

  /// Brings a point up to date that is kept, not found again, as Bullet's refresh would: one that is held is anchored
  /// with the slip that it may have, and placed without any other.
  void RefreshKept(btManifoldPoint& point) const {
    btVector3 place_a = a_.pose(point.m_localPointA), place_b = b_.pose(point.m_localPointB);
    const bool can_hold = CanHold(point);
    btVector3 excess = Across(place_a - place_b, point.m_normalWorldOnB);
    if (can_hold) excess -= SlipOf(point, place_a, place_b);
    if (excess.length2() > roundoff_ * roundoff_) {
      const btVector3 half = btScalar(0.5) * excess;
      place_a -= half;
      place_b += half;
      point.m_localPointA -= half * a_.pose.getBasis();
      point.m_localPointB += half * b_.pose.getBasis();
    }
    point.m_contactPointFlags &= ~BT_CONTACT_FLAG_FRICTION_ANCHOR;
    if (can_hold) point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
    Place(point, place_a, place_b);
  }

 private:
  struct Body {
    explicit Body(const btCollisionObject& object)
        : pose(object.getWorldTransform()),
          velocity(VelocityOf(object)),
          is_moved_by_app(object.isStaticOrKinematicObject() &&
                          !(velocity.linear.isZero() && velocity.angular.isZero())) {}

    const btTransform& pose;
    BodyVelocity velocity;
    bool is_moved_by_app;  // A static or kinematic body with a velocity: the solver does not change it.
  };

  btVector3 SlipOf(const btManifoldPoint& point, const btVector3& place_a, const btVector3& place_b) const {
    const btVector3 none(0, 0, 0);
    if ((point.m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR) == 0) return none;
    const btVector3& normal = point.m_normalWorldOnB;
    const btVector3 apart = place_a - place_b;
    const btVector3 by_velocity =
        time_step_ * (linear_at_a_ + turning_.cross(place_a - a_.pose.getOrigin()));  // Since the last step.
    const btVector3 unexplained =
        Across(apart - (point.m_positionWorldOnA - point.m_positionWorldOnB) - by_velocity, normal);
    const btScalar allowed_sq = kSameSlip * kSameSlip * by_velocity.length2() + roundoff_ * roundoff_;
    if (!(unexplained.length2() <= allowed_sq)) return none;
    const btVector3 slip = Across(apart, normal);
    const btScalar length_sq = slip.length2();
    return length_sq > max_slip_ * max_slip_ ? (max_slip_ / btSqrt(length_sq)) * slip : slip;
  }

  static void Place(btManifoldPoint& point, const btVector3& place_a, const btVector3& place_b) {
    point.m_positionWorldOnA = place_a;
    point.m_positionWorldOnB = place_b;
    point.m_distance1 = (place_a - place_b).dot(point.m_normalWorldOnB);
  }

  static btVector3 Across(const btVector3& way, const btVector3& normal) { return way - way.dot(normal) * normal; }

  /// Of the breaking threshold: a body that slips by more has slid. By measurement (contact_report, float, no resting
  /// contacts kept): with this scenes/pyramid_28.json creeps by 1.3 mm in a minute, with a tenth of it by 25 mm.
  static constexpr btScalar kMaxSlip = btScalar(0.01);
  /// How far the slip may be from what the velocities say, of that: a constant turn's arc is off by less.
  static constexpr btScalar kSameSlip = btScalar(0.1);
  /// Poses are off by so many last digits of their coordinates; and slip that is known less well than this part of the
  /// largest is not held.
  static constexpr btScalar kRoundings = 2, kMostRoundoff = btScalar(0.05);

  const Body a_, b_;
  const btScalar time_step_;
  btVector3 linear_at_a_{0, 0, 0}, turning_{0, 0, 0};  // Of A as B sees it: velocity at A's origin, and angular.
  btScalar max_slip_ = 0, roundoff_ = 0;               // Metres.
  bool can_hold_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
