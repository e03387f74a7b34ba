// Between Bullet's vectors, of either precision, and the solver's, always double.
//
// The solver works in double also for Bullet's float build: the conversion costs a nanosecond, and a pose in float is
// exact in double, so what Bullet users know as float trouble (relative poses, tiny features) does not arise.
#pragma once

#include <LinearMath/btTransform.h>
#include <LinearMath/btVector3.h>

#include "dgd/types.h"

namespace dgd_bullet {

using Vector3 = dgd::Vector3<double>;
using Matrix3 = dgd::Matrix3<double>;
using Pose = dgd::Pose<double>;

inline Vector3 FromBullet(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

inline btVector3 ToBullet(const Vector3& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }

/// Columns `first`, then the two that follow it cyclically: the rotation of a frame whose z axis is Bullet's axis
/// `up` is the one that starts with the axis after `up`.
inline Pose FromBullet(const btTransform& transform, int up_axis) {
  const btMatrix3x3& basis = transform.getBasis();
  Pose pose;
  for (int column = 0; column < 3; ++column) {
    const int axis = (up_axis + 1 + column) % 3;
    for (int row = 0; row < 3; ++row) pose.rotation(row, column) = double(basis[row][axis]);
  }
  pose.translation = FromBullet(transform.getOrigin());
  return pose;
}

}  // namespace dgd_bullet
