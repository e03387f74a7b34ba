#include "render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dgd_demos {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAzimuth = -62 * kDegree;         // Of the camera, seen from the target, from the x axis.
constexpr double kElevation = 26 * kDegree;        // Above the ground.
constexpr double kHalfFieldOfView = 15 * kDegree;  // Vertical; narrow, so that near and far bodies compare in size.
// Share of the half picture that the bodies may fill; the rest is air, and holds title and legend.
constexpr double kFilledWidth = 0.94;
constexpr double kFilledHeight = 0.80;

Matrix3d FixedAxes() {
  const Vector3d backward(std::cos(kElevation) * std::cos(kAzimuth), std::cos(kElevation) * std::sin(kAzimuth),
                          std::sin(kElevation));
  Matrix3d axes;
  axes.col(0) = Vector3d::UnitZ().cross(backward).normalized();
  axes.col(1) = backward.cross(axes.col(0));
  axes.col(2) = backward;
  return axes;
}

}  // namespace

Matrix3d Camera::AxesInWorld() const { return FixedAxes(); }

Matrix4d Camera::ViewProjection(double aspect) const {
  const double near = 0.05 * distance, far = 10 * distance;
  const double focal = 1 / std::tan(kHalfFieldOfView);
  Matrix4d projection = Matrix4d::Zero();
  projection(0, 0) = focal / aspect;
  projection(1, 1) = focal;
  projection(2, 2) = (near + far) / (near - far);
  projection(2, 3) = 2 * near * far / (near - far);
  projection(3, 2) = -1;

  Matrix4d view = Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = AxesInWorld().transpose();
  view.topRightCorner<3, 1>() = -AxesInWorld().transpose() * Position();
  return projection * view;
}

Camera FrameAll(const std::vector<Ball>& balls, double aspect) {
  const Matrix3d axes = FixedAxes();
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Ball& ball : balls) {
    const Vector3d centre = axes.transpose() * ball.centre;
    const Vector3d extent = Vector3d::Constant(ball.radius);
    low = low.cwiseMin(centre - extent);
    high = high.cwiseMax(centre + extent);
  }
  const Vector3d middle = (low + high) / 2;

  // Each ball must keep clear of the four side planes of the pyramid of view.
  const double half_height = kFilledHeight * std::tan(kHalfFieldOfView);
  const double half_width = kFilledWidth * aspect * std::tan(kHalfFieldOfView);
  double distance = 0;
  for (const Ball& ball : balls) {
    const Vector3d offset = axes.transpose() * ball.centre - middle;
    const auto needed = [&](double sideways, double half_size) {
      return offset.z() + (std::abs(sideways) + ball.radius * std::hypot(1, half_size)) / half_size;
    };
    distance = std::max({distance, needed(offset.x(), half_width), needed(offset.y(), half_height)});
  }
  return {axes * middle, distance};
}

}  // namespace dgd_demos
