// One second-order step of pieces that bend differently: it ends where they are equally high.
#include "dgd/solver/newton_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dgd_test {
namespace {

using Step = dgd::NewtonStepModel<double, 3>;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A piece whose support function is known everywhere.
struct Ball {
  Vector3d center;
  double radius;

  /// Of its plane with the normal (u, 1), on the ray.
  double HeightAt(const Vector2d& u) const {
    const Vector3d direction(u.x(), u.y(), 1);
    return direction.dot(center) + radius * direction.norm();
  }
  Vector3d Top() const { return center + radius * Vector3d::UnitZ(); }
};

/// Equally high along the ray itself; the lowest plane of both is to the side, where the large one bends upwards.
constexpr double kHeight = 1.8;
Ball Small() { return {{0.4, 0.1, kHeight - 0.05}, 0.05}; }
Ball Large() { return {{-0.4, 0.1, kHeight - 0.8}, 0.8}; }

Vector2d StepOf(bool is_large_a_plane) {
  Step step(kHeight, 1);
  step.Add(Small().Top(), Small().radius * Eigen::Matrix2d::Identity(), kHeight, false);
  step.Add(Large().Top(), Large().radius * Eigen::Matrix2d::Identity(), kHeight, is_large_a_plane);
  EXPECT_TRUE(step.Solve(0b11));
  EXPECT_TRUE(step.IsActive(0));
  EXPECT_TRUE(step.IsActive(1));
  return step.Step();
}

TEST(NewtonStepModel, PiecesThatBendDifferently_AreEquallyHighAfterIt) {
  const Vector2d step = StepOf(false);
  EXPECT_LT(step.y(), -0.1);
  EXPECT_LT(std::abs(Small().HeightAt(step) - Large().HeightAt(step)), 0.1 * step.squaredNorm() * Large().radius / 2);
  // Not a step too far.
  EXPECT_LT(Large().HeightAt(step), kHeight);
}

// How the feature of a plane bends, the plane does not say.
TEST(NewtonStepModel, Planes_AreIntersectedAsTheyAre) {
  const Vector2d step = StepOf(true);
  EXPECT_LT(step.y(), -0.1);
  EXPECT_NEAR(step.x(), 0, 1e-15);
}

}  // namespace
}  // namespace dgd_test
