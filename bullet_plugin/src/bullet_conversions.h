// Between Bullet's vectors and poses, of either precision, and the solver's.
#pragma once

#include <LinearMath/btTransform.h>
#include <LinearMath/btVector3.h>

#include "solver_types.h"

namespace dgd_bullet {

inline Vector3 FromBullet(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

inline btVector3 ToBullet(const Vector3& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }

/// The pose of a set whose z axis is Bullet's axis `up_axis`: the columns that follow it cyclically come first.
inline Pose FromBullet(const btTransform& transform, int up_axis) {
  const btMatrix3x3& basis = transform.getBasis();
  const int x = up_axis == 2 ? 0 : up_axis + 1, y = x == 2 ? 0 : x + 1;
  Matrix3 rotation;
  for (int row = 0; row < 3; ++row) {
    rotation(row, 0) = double(basis[row][x]);
    rotation(row, 1) = double(basis[row][y]);
    rotation(row, 2) = double(basis[row][up_axis]);
  }
  return {rotation, FromBullet(transform.getOrigin())};
}

}  // namespace dgd_bullet
