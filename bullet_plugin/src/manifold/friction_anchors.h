// Friction anchors: contacts that stick are pulled back to where they stuck (Options::friction_anchors).
//
// Friction opposes speed in Bullet's solver, and the speed that its iterations leave is never corrected: piles creep by
// millimetres a minute. Its own anchors (btCollisionObject::CF_HAS_FRICTION_ANCHOR) correct the displacement as well,
// but preserve a point with its old normal and place, so that a wheel is pulled to where it stood. Here an anchor
// corrects only the slip that the solver has left: the displacement by which the two places of a contact that has stuck
// for two steps or more have moved apart according to their bodies' velocities. Not anchored are what rolls or slides,
// surfaces with a velocity of their own, and bodies that an app moves or pushes between two steps.
//
// Physics: the correction is within the friction cone, and up to a hundredth of the breaking threshold (tests/physics:
// slide, swing_force, taps, belt, platform, feeder, teleport).
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

#include <limits>

#include "body_velocity.h"
#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "lengths.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The least number of points that are anchored: on fewer, bodies rock, and would be given back what they slipped
/// (fifty polytopes come to rest a tenth later).
constexpr int kMinAnchors = 3;

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
/// the last step's.
class FrictionAnchors {
 public:
  /// @param manifold   The pair's own, of bodies that Bullet itself anchors nothing on.
  /// @param time_step  Seconds; 0 to anchor nothing.
  FrictionAnchors(const btPersistentManifold& manifold, btScalar time_step)
      : a_(*manifold.getBody0()),
        b_(*manifold.getBody1()),
        time_step_(time_step),
        max_slip_(btScalar(kSlipPart) * manifold.getContactBreakingThreshold()) {
    DGD_ASSERT(!(time_step < 0));
    can_anchor_ = time_step > 0 && !a_.is_moved_by_app && !b_.is_moved_by_app;
    if (!can_anchor_) return;
    const btScalar farthest =
        btMax(a_.pose.getOrigin().absolute().dot({1, 1, 1}), b_.pose.getOrigin().absolute().dot({1, 1, 1}));
    roundoff_ = kRoundings * std::numeric_limits<btScalar>::epsilon() * farthest;
    can_anchor_ = roundoff_ <= kMaxRoundoff * max_slip_;
    turning_ = a_.velocity.angular - b_.velocity.angular;
    linear_at_a_ =
        a_.velocity.linear - b_.velocity.linear - b_.velocity.angular.cross(a_.pose.getOrigin() - b_.pose.getOrigin());
  }

  /// Whether a point may be anchored from this step on.
  bool CanAnchor(const btManifoldPoint& point) const {
    return can_anchor_ && point.getLifeTime() > 0 && Sticks(point) && CanBeAnchored(point);
  }

  /// The slip that the solver has left at a point that can be anchored, since it has been: B to A, across the normal,
  /// world, metres; zero if something else has moved its places apart, too.
  btVector3 SlipOf(const btManifoldPoint& point) const {
    return SlipOf(point, a_.pose(point.m_localPointA), b_.pose(point.m_localPointB));
  }

  /// Makes the solver correct the slip of a point that has just been placed without any.
  void Anchor(btManifoldPoint& point, const btVector3& slip) const {
    DGD_ASSERT(slip.length2() <= btScalar(1.01) * max_slip_ * max_slip_);
    if (!CanBeAnchored(point)) return;  // This step's callback moves the surface.
    DGD_ASSERT(can_anchor_);
    const btVector3 half = btScalar(0.5) * slip;
    point.m_positionWorldOnA += half;
    point.m_positionWorldOnB -= half;
    point.m_localPointA += half * a_.pose.getBasis();
    point.m_localPointB -= half * b_.pose.getBasis();
    point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
  }

  /// Updates a recycled point, as Bullet's refresh would: one that can be anchored is placed with the slip that it may
  /// have, and without any other.
  void RefreshRecycled(btManifoldPoint& point) const {
    btVector3 place_a = a_.pose(point.m_localPointA), place_b = b_.pose(point.m_localPointB);
    const bool can_anchor = CanAnchor(point);
    btVector3 excess = Across(place_a - place_b, point.m_normalWorldOnB);
    if (can_anchor) excess -= SlipOf(point, place_a, place_b);
    if (excess.length2() > roundoff_ * roundoff_) {
      const btVector3 half = btScalar(0.5) * excess;
      place_a -= half;
      place_b += half;
      point.m_localPointA -= half * a_.pose.getBasis();
      point.m_localPointB += half * b_.pose.getBasis();
    }
    point.m_contactPointFlags &= ~BT_CONTACT_FLAG_FRICTION_ANCHOR;
    if (can_anchor) point.m_contactPointFlags |= BT_CONTACT_FLAG_FRICTION_ANCHOR;
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
        time_step_ *
        (linear_at_a_ + turning_.cross(place_a - a_.pose.getOrigin()));  // Displacement since the last step.
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

  static btVector3 Across(const btVector3& vector, const btVector3& normal) {
    return vector - vector.dot(normal) * normal;
  }

  /// How far the slip may differ from the velocities' displacement, as a part of that: a constant turn's arc differs by
  /// less.
  static constexpr btScalar kSameSlip = btScalar(0.1);
  /// Roundoff of poses, in last digits of their coordinates; and the part of the largest slip above which roundoff
  /// makes it too uncertain to be corrected.
  static constexpr btScalar kRoundings = 2, kMaxRoundoff = btScalar(0.05);

  const Body a_, b_;
  const btScalar time_step_;
  const btScalar max_slip_;                            // In metres.
  btVector3 linear_at_a_{0, 0, 0}, turning_{0, 0, 0};  // Velocity of A's origin as B sees it, and angular velocity.
  btScalar roundoff_ = 0;                              // Metres.
  bool can_anchor_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
