// Conversions between Bullet's vectors and poses, of either precision, and the solver's.
#pragma once

#include <LinearMath/btTransform.h>
#include <LinearMath/btVector3.h>

#include <cmath>
#include <limits>

#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "solver_types.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Stores the vector as Eigen will load it, a pair of numbers and one: a pair that is loaded from two single stores, as
/// Eigen's own constructor makes them, waits some 12 cycles for both to reach the cache.
inline Vector3 FromBullet(const btVector3& v) {
  using Pair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
  Vector3 vector;
  *reinterpret_cast<Pair*>(vector.data()) = Pair{double(v.x()), double(v.y())};
  vector[2] = double(v.z());
  return vector;
}

inline btVector3 ToBullet(const Vector3& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }

/// The up axis of a set whose frame is the Bullet shape's own.
constexpr int kZAxis = 2;

/// The two axes that follow Bullet's axis `up_axis` cyclically.
struct AcrossAxes {
  explicit AcrossAxes(int up_axis) : x(up_axis == kZAxis ? 0 : up_axis + 1), y(x == kZAxis ? 0 : x + 1) {
    DGD_ASSERT(up_axis >= 0 && up_axis <= kZAxis);
  }

  int x, y;
};

/// A direction of the frame that FromBullet() gives a pose with this up axis, in Bullet's own.
inline btVector3 InBulletAxes(const Vector3& v, int up_axis) {
  switch (up_axis) {
    case 0:
      return ToBullet({v.z(), v.x(), v.y()});
    case 1:
      return ToBullet({v.y(), v.z(), v.x()});
    default:
      return ToBullet(v);
  }
}

/// A value in Bullet's precision, rounded down.
inline btScalar RoundDown(double value) {
  const btScalar rounded = btScalar(value);
  return double(rounded) > value ? std::nextafter(rounded, -std::numeric_limits<btScalar>::infinity()) : rounded;
}

/// The pose of a set whose z axis is Bullet's axis `up_axis`: the columns that follow it cyclically come first. Filled
/// in place: copying a matrix whose numbers were just stored one by one waits for all of them.
inline Pose FromBullet(const btTransform& transform, int up_axis = kZAxis) {
  const btMatrix3x3& basis = transform.getBasis();
  const auto [x, y] = AcrossAxes(up_axis);
  Pose pose;
  for (int row = 0; row < 3; ++row) {
    pose.rotation(row, 0) = double(basis[row][x]);
    pose.rotation(row, 1) = double(basis[row][y]);
    pose.rotation(row, 2) = double(basis[row][up_axis]);
    pose.translation[row] = double(transform.getOrigin()[row]);
  }
  return pose;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
