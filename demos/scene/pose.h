// A rigid pose: from a body's local frame to the world.
#pragma once

#include <Eigen/Core>

namespace dgd_demos {

struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< Orthonormal, body to world.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< Of the local origin, m.

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + position; }
  /// Of a pose in this one's frame, the pose in the frame that this one is in.
  Pose operator*(const Pose& child) const { return {rotation * child.rotation, *this * child.position}; }
};

}  // namespace dgd_demos
