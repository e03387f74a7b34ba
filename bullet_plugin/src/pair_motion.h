// How far two bodies approach each other within the time step, by their velocities before the constraints are solved.
#pragma once

#include "bullet_conversions.h"

struct btCollisionObjectWrapper;

namespace dgd_bullet {

/// The motion of B relative to A as a screw: at x, velocity = linear + angular x (x - origin).
class PairMotion {
 public:
  /// Bodies at rest to each other.
  PairMotion() = default;

  /// The bodies' motion over `time_step` seconds. Only rigid bodies have velocities; others count as at rest.
  PairMotion(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b, double time_step);

  /// Metres by which the surfaces come closer along `normal` (unit, from A to B) at a world point; negative if they
  /// part.
  double Approach(const Vector3& point, const Vector3& normal) const {
    return -normal.dot(displacement_ + rotation_.cross(point - origin_));
  }

  /// No point of either body approaches the other by more than this, metres.
  double MaxApproach() const { return max_approach_; }

 private:
  Vector3 origin_ = Vector3::Zero();        // World, metres.
  Vector3 displacement_ = Vector3::Zero();  // Of B relative to A at the origin, metres.
  Vector3 rotation_ = Vector3::Zero();      // Of B relative to A, radians.
  double max_approach_ = 0;
};

}  // namespace dgd_bullet
