// One second-order step of two pieces: to where their planes meet, and along that line to its lowest point.
#include "dgd/solver/newton_step.h"

#include <gtest/gtest.h>

namespace dgd_test {
namespace {

using Step = dgd::NewtonStepModel<double, 3>;
using Eigen::Vector3d;

/// A piece of a ball.
struct Ball {
  Vector3d center;
  double radius;

  Vector3d Top() const { return center + radius * Vector3d::UnitZ(); }
};

/// Equally high along the ray itself; the lowest plane of both is to the side, where the large one bends upwards.
constexpr double kHeight = 1.8;
Ball Small() { return {{0.4, 0.1, kHeight - 0.05}, 0.05}; }
Ball Large() { return {{-0.4, 0.1, kHeight - 0.8}, 0.8}; }

TEST(NewtonStepModel, TwoPieces_GoAlongTheLineWhereTheirPlanesMeet) {
  Step step(kHeight, 1);
  for (const Ball& ball : {Small(), Large()}) {
    step.Add(ball.Top(), ball.radius * Eigen::Matrix2d::Identity(), kHeight);
  }
  EXPECT_TRUE(step.Solve(0b11));
  EXPECT_TRUE(step.IsActive(0));
  EXPECT_TRUE(step.IsActive(1));
  EXPECT_LT(step.Step().y(), -0.1);
  EXPECT_NEAR(step.Step().x(), 0, 1e-15);
}

}  // namespace
}  // namespace dgd_test
