#include "dgd/shapes/half_space.h"

#include <gtest/gtest.h>

#include "dgd/convex_set.h"

namespace dgd_test {
namespace {

TEST(HalfSpace, Distance_IsTheHeightAboveTheBorder) {
  const dgd::HalfSpace<double> ground;
  EXPECT_EQ(ground.Distance({3, -4, 0.5}), 0.5);
  EXPECT_EQ(ground.Distance({3, -4, -0.5}), 0);
  EXPECT_EQ(ground.Distance(ground.Center()), 0);
  EXPECT_EQ(ground.Normal(), Eigen::Vector3d(0, 0, 1));
}

TEST(HalfPlane, Distance_IsTheHeightAboveTheBorder) {
  const dgd::HalfPlane<float> ground;
  EXPECT_EQ(ground.Distance({3, 0.5F}), 0.5F);
  EXPECT_EQ(ground.Distance({0.5F, -3}), 0.0F);
  EXPECT_EQ(ground.Normal(), Eigen::Vector2f(0, 1));
}

// The solver must not take it for a compact set.
static_assert(!dgd::ConvexCore<dgd::HalfSpace<double>>);
static_assert(!dgd::ConvexCore<dgd::HalfPlane<float>>);

}  // namespace
}  // namespace dgd_test
