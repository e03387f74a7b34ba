#include "support/sets/stretch.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

#include "support/random.h"

namespace dgd_test {
namespace {

/// Rotations before and after leave the stretches along the axes.
TEST(Stretch, InSpace_IsOfTheAxes) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d along(1e-9, random.Uniform(0.1, 1), -7);
    const Eigen::Matrix3d linear = random.Rotation() * along.asDiagonal() * random.Rotation();
    const Stretch stretch = StretchOf(linear);
    EXPECT_NEAR(stretch.most, 7, 1e-14);
    EXPECT_NEAR(stretch.least, 1e-9, 1e-14);
  }
}

TEST(Stretch, InThePlane_IsOfTheAxes) {
  Random random(TestSeed());
  const auto turn = [&] { return Eigen::Rotation2Dd(random.Uniform(0, 2 * std::numbers::pi)).toRotationMatrix(); };
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix2d linear = turn() * Eigen::Vector2d(-0.25, 3).asDiagonal() * turn();
    const Stretch stretch = StretchOf(linear);
    EXPECT_NEAR(stretch.most, 3, 1e-14);
    EXPECT_NEAR(stretch.least, 0.25, 1e-14);
  }
}

TEST(Stretch, OfWhatFlattens_HasNoLeast) {
  EXPECT_EQ(StretchOf(Eigen::Matrix3d(Eigen::Vector3d(2, 1, 0).asDiagonal())).least, 0);
  EXPECT_EQ(StretchOf(Eigen::Matrix2d(Eigen::Matrix2d::Zero())).most, 0);
}

}  // namespace
}  // namespace dgd_test
