// A rigid motion between two moments, as simulations and planners step bodies: straight, and turning evenly.
#pragma once

#include "dgd/types.h"

namespace dgd {

/// The motion of a set's frame over a time from 0 to 1: one point of it moves on a straight line, and the frame turns
/// about that point at a constant rate.
template <class S>
struct Motion {
  Pose<S> start;
  Vector3<S> translation = Vector3<S>::Zero();  ///< Translation of the point, metres, world.
  Vector3<S> rotation = Vector3<S>::Zero();     ///< Radians times the axis, world; more than a turn if need be.
  Vector3<S> center = Vector3<S>::Zero();       ///< The point, in the set's frame, metres.

  Vector3<S> CenterAt(S time) const { return start * center + time * translation; }

  SquareMatrix<S, 3> RotationAt(S time) const {
    const S angle = rotation.norm();
    if (!(time * angle > 0)) return start.rotation;
    return Eigen::AngleAxis<S>(time * angle, rotation / angle).toRotationMatrix() * start.rotation;
  }

  Pose<S> At(S time) const {
    Pose<S> pose;
    pose.rotation = RotationAt(time);
    pose.translation = CenterAt(time) - pose.rotation * center;
    return pose;
  }

  bool IsFinite() const {
    return start.rotation.allFinite() && start.translation.allFinite() && translation.allFinite() &&
           rotation.allFinite() && center.allFinite();
  }

  /// The motion from one pose to another by the shortest turn, about the frame's origin.
  static Motion Between(const Pose<S>& start, const Pose<S>& end) {
    const Eigen::AngleAxis<S> turn(Matrix3<S>(end.rotation * start.rotation.transpose()));
    return {start, end.translation - start.translation, turn.angle() * turn.axis()};
  }
};

}  // namespace dgd
