// Contract of FrameAll: every ball is in the picture, and the picture is not mostly empty.
#include "render/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/random.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// The largest coordinate on the screen, 1 at its rim, that any point of the balls' surfaces has.
double Reach(const std::vector<Ball>& balls, const Camera& camera, double aspect, Random& random) {
  const Eigen::Matrix4d matrix = camera.ViewProjection(aspect);
  double reach = 0;
  for (const Ball& ball : balls) {
    for (int i = 0; i < 200; ++i) {
      const Vector3d point = ball.centre + ball.radius * random.UnitVector();
      const Eigen::Vector4d clip = matrix * point.homogeneous();
      EXPECT_GT(clip.w(), 0) << "behind the camera";
      EXPECT_LT(std::abs(clip.z() / clip.w()), 1) << "beyond near or far";
      reach = std::max({reach, std::abs(clip.x() / clip.w()), std::abs(clip.y() / clip.w())});
    }
  }
  return reach;
}

TEST(CameraTest, FrameAll_HoldsEveryBallWithoutWastingThePicture) {
  Random random(61, 0);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Ball> balls;
    const Vector3d extent(random.Uniform(0.1, 10), random.Uniform(0.1, 10), random.Uniform(0.1, 10));
    for (int i = 0; i <= trial; ++i) balls.push_back({random.InBox(-extent, extent), random.Uniform(0.1, 1)});
    for (const double aspect : {16.0 / 9, 4.0 / 3, 0.7}) {
      const double reach = Reach(balls, FrameAll(balls, aspect), aspect, random);
      EXPECT_LT(reach, 1);
      EXPECT_GT(reach, 0.5);
    }
  }
}

}  // namespace
}  // namespace dgd_demos
