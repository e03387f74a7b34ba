// Where a picture is taken from.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dgd_demos {

/// A ball that must be in the picture.
struct Ball {
  Eigen::Vector3d centre;
  double radius;
};

/// Looks along a fixed, slightly raised direction, upright, with a fixed field of view.
struct Camera {
  Eigen::Vector3d target;  ///< Projected to the middle of the picture, m.
  double distance;         ///< From the target, m.

  Eigen::Matrix3d AxesInWorld() const;  ///< Columns: right, up, backward.
  Eigen::Vector3d Position() const { return target + distance * AxesInWorld().col(2); }
  /// World to clip space. @param aspect  width / height.
  Eigen::Matrix4d ViewProjection(double aspect) const;
};

/// The nearest camera that has all balls in the picture, with some air around them. @pre at least one ball.
Camera FrameAll(const std::vector<Ball>& balls, double aspect);

}  // namespace dgd_demos
