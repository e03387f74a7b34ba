// How far two bodies approach each other within the time step, by their velocities and the forces on them before the
// constraints are solved.
#pragma once

#include <algorithm>
#include <utility>

#include "bullet_conversions.h"
#include "dgd/motion.h"
#include "dgd_bullet/linkage.h"

class btCollisionObject;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Distance from a world point, as the body's origin, to the farthest corner of the body's bounding box: no point of
/// the body is farther. Of a body that is in no broadphase, by Bullet's own bound, which computes a bounding box first.
double BoundingRadius(const btCollisionObject& object, const btVector3& from);

/// A body, and the distance of its farthest point from its origin, metres.
struct BoundedBody {
  explicit BoundedBody(const btCollisionObject& body);

  const btCollisionObject& object;
  double radius;
};

class PairMotion {
 public:
  /// Bodies at rest to each other.
  PairMotion() = default;

  /// The bodies' motion over `time_step` seconds. What is neither a rigid body nor a multibody's link counts as at
  /// rest.
  PairMotion(const BoundedBody& body_a, const BoundedBody& body_b, double time_step);

  /// Whether this is a motion over a time step, and not the default.
  bool IsKnown() const { return time_step_ > 0; }
  double TimeStep() const { return time_step_; }

  /// Whether one of the bodies is a multibody's link.
  bool IsOfLinks() const { return a_.is_link || b_.is_link; }

  /// The length by which the surfaces come closer along `normal` (unit, from A to B) at a world point within the step,
  /// if no constraint acts, in metres; negative if they part.
  double Approach(const Vector3& point, const Vector3& normal) const {
    return time_step_ * normal.dot(a_.PredictedVelocityAt(point) - b_.PredictedVelocityAt(point));
  }
  /// Approach() by the present velocities alone: what supports a body takes up its weight.
  double Coasting(const Vector3& point, const Vector3& normal) const {
    return time_step_ * ApproachSpeed(point, point, normal);
  }
  /// The speed at which a point of A and one of B come closer now, and what the forces add to it within the step;
  /// metres per second.
  double ApproachSpeed(const Vector3& on_a, const Vector3& on_b, const Vector3& normal) const {
    return normal.dot(a_.VelocityAt(on_a) - b_.VelocityAt(on_b));
  }
  double ApproachSpeedGain(const Vector3& normal) const { return normal.dot(a_.gain - b_.gain); }

  /// A bound on how far any point of either body approaches the other; metres.
  double MaxApproach() const {
    return time_step_ * (RelativeVelocity().norm() + a_.angular.norm() * a_.rim + b_.angular.norm() * b_.rim);
  }
  /// Whether a point of either body may approach the other by as much as `distance` along `normal` (unit, from A to B),
  /// metres; also where velocities are NaN. Mostly without a root.
  bool MayApproachBy(double distance, const Vector3& normal) const {
    return MayCloseBy(distance, normal, normal.dot(RelativeVelocity()));
  }
  /// MayApproachBy() by the present velocities alone.
  bool MayCoastBy(double distance, const Vector3& normal) const {
    return MayCloseBy(distance, normal, normal.dot(a_.linear - b_.linear));
  }

  /// This motion with the bodies in the other order.
  PairMotion Reversed() const {
    PairMotion reversed = *this;
    std::swap(reversed.a_, reversed.b_);
    return reversed;
  }

  /// Whether no point of either body goes farther than `distance`, metres.
  bool IsWithin(double distance) const {
    return time_step_ * a_.Speed() <= distance && time_step_ * b_.Speed() <= distance;
  }

  /// Rotation of body A as body B sees it: radians times the axis, world.
  Vector3 Turn() const { return time_step_ * (a_.angular - b_.angular); }

  /// A bound on how far a point of body A that is at a world point strays within the step from the straight way of
  /// Approach(), as body B sees it: on arcs about both centres; metres.
  double Bend(const Vector3& point) const;

  /// How far one body's point that is at a world point goes, as the other body sees it; metres.
  double Slip(const Vector3& point) const { return time_step_ * (a_.VelocityAt(point) - b_.VelocityAt(point)).norm(); }
  /// How far the smaller body's rim goes as a direction of its own, now the world's `normal`, tilts in the other's
  /// eyes; metres.
  double Tilt(const Vector3& normal) const {
    return time_step_ * (a_.angular - b_.angular).cross(normal).norm() * std::min(a_.radius, b_.radius);
  }

  /// Whether bodies that turn about one contact go on turning about another one where they land next, and leave the
  /// first: a wheel does, a rod that comes to lie does not. By Housner's impact, in which a body sticks where it lands
  /// and keeps its angular momentum about that place: k^2 + <from - c, to - c> > 0 across the axis, with the centre of
  /// mass c and the radius of gyration k (G. Housner, The behavior of inverted pendulum structures during earthquakes,
  /// 1963). What lands no faster than its weight makes it in one step does not either: it would rock to and fro faster
  /// than steps can follow, which is to stand. Nor do bodies at places one above the other, about which nothing turns.
  /// @param from, to  Places of the contacts, world, metres.
  /// @param normal    Of both, unit, world.
  bool TurnOver(const Vector3& from, const Vector3& to, const Vector3& normal) const {
    const Vector3 axis = (to - from).cross(normal);
    return a_.TurnsOver(from, to, axis) && b_.TurnsOver(from, to, axis) &&
           ApproachSpeed(to, to, normal) > a_.TippingSpeed(from, axis) - b_.TippingSpeed(from, axis);
  }

  /// The motion of a pose that is fixed to a body over the time step, by the body's present velocity.
  dgd::Motion<double> MotionOfA(const Pose& pose) const { return a_.MotionOf(pose, time_step_); }
  dgd::Motion<double> MotionOfB(const Pose& pose) const { return b_.MotionOf(pose, time_step_); }

 private:
  struct Twist {
    Vector3 VelocityAt(const Vector3& point) const { return linear + angular.cross(point - center); }
    Vector3 PredictedVelocityAt(const Vector3& point) const { return VelocityAt(point) + gain; }
    dgd::Motion<double> MotionOf(const Pose& pose, double time) const;
    double Speed() const { return linear.norm() + angular.norm() * radius; }
    /// No point goes faster along `normal` by rotation alone, on average over any time: turned by an angle about an
    /// axis, a unit vector's end goes that angle at most times its distance from the axis.
    double RimSpeed(const Vector3& normal) const { return angular.cross(normal).norm() * rim; }
    /// The square of the radius of gyration about an axis through the centre of mass, of any length; square metres,
    /// infinite for what contacts do not turn. Links count as that: their neighbours take part in an impact.
    double GyrationSq(const Vector3& axis) const;
    bool TurnsOver(const Vector3& from, const Vector3& to, const Vector3& axis) const;
    /// The speed along the normal that the forces on the body give the place `to` within the step as it turns about
    /// `from`; metres per second.
    /// @param axis  (to - from) x normal, as of TurnsOver(), metres.
    double TippingSpeed(const Vector3& from, const Vector3& axis) const;

    Vector3 linear = Vector3::Zero();         // Velocity of the centre of mass, metres per second.
    Vector3 angular = Vector3::Zero();        // Angular velocity, radians per second.
    Vector3 gain = Vector3::Zero();           // What the forces on the body add to its velocity within the step.
    Vector3 center = Vector3::Zero();         // Centre of mass, world, metres.
    const btCollisionObject* body = nullptr;  // The body, unless it never moves.
    double radius = 0;                        // Distance of the farthest point from the centre, metres.
    double rim = 0;        // Distance of the farthest point that approaches anything as the body turns, metres.
    bool is_link = false;  // Whether it is a multibody's link.
  };

  static Twist Read(const BoundedBody& body, double time_step);

  /// @param along  Speed of the centres' approach along the normal, metres per second.
  bool MayCloseBy(double distance, const Vector3& normal, double along) const {
    const double around = a_.angular.lpNorm<1>() * a_.rim + b_.angular.lpNorm<1>() * b_.rim;
    if (time_step_ * (along + around) < distance) return false;
    return !(time_step_ * (along + a_.RimSpeed(normal) + b_.RimSpeed(normal)) < distance);
  }

  Vector3 RelativeVelocity() const { return (a_.linear + a_.gain) - (b_.linear + b_.gain); }

  Twist a_, b_;
  double time_step_ = 0;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
