// Between Eigen in double and Bullet in its own precision.
#pragma once

#include <LinearMath/btTransform.h>

#include <Eigen/Core>

#include "scene/pose.h"

namespace dgd_demos {

inline btScalar ToBullet(double value) { return static_cast<btScalar>(value); }

inline btVector3 ToBullet(const Eigen::Vector3d& vector) {
  return {ToBullet(vector.x()), ToBullet(vector.y()), ToBullet(vector.z())};
}

inline btTransform ToBullet(const Pose& pose) {
  const Eigen::Matrix3d& r = pose.rotation;
  return btTransform(
      btMatrix3x3(ToBullet(r(0, 0)), ToBullet(r(0, 1)), ToBullet(r(0, 2)), ToBullet(r(1, 0)), ToBullet(r(1, 1)),
                  ToBullet(r(1, 2)), ToBullet(r(2, 0)), ToBullet(r(2, 1)), ToBullet(r(2, 2))),
      ToBullet(pose.position));
}

inline Eigen::Vector3d FromBullet(const btVector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

inline Pose FromBullet(const btTransform& transform) {
  Pose pose;
  for (int i = 0; i < 3; ++i) pose.rotation.row(i) = FromBullet(transform.getBasis().getRow(i));
  pose.position = FromBullet(transform.getOrigin());
  return pose;
}

}  // namespace dgd_demos
