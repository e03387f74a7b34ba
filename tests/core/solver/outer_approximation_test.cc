#include "dgd/solver/outer_approximation.h"

#include <gtest/gtest.h>

#include <limits>

namespace dgd_test {
namespace {

using Eigen::Vector3d;

TEST(OuterApproximation, BeforeTheFirstCut_BoundsNothing) {
  EXPECT_EQ(dgd::OuterApproximation<double>().Height(), std::numeric_limits<double>::infinity());
}

TEST(OuterApproximation, Cuts_KeepTheLowestPlane) {
  dgd::OuterApproximation<double> outer;
  dgd::DifferencePoint<double> low, high;
  low.on_1 = Vector3d(1, 2, 3);
  high.on_1 = Vector3d(4, 5, 6);
  outer.Cut({0, 0, 1}, 2, high);
  EXPECT_EQ(outer.Height(), 2);
  outer.Cut({0.6, 0, 0.8}, 0.8, low);
  EXPECT_EQ(outer.Height(), 1);
  outer.Cut({0, 0, 1}, 1.5, high);
  EXPECT_EQ(outer.Height(), 1);
  EXPECT_EQ(outer.Normal(), Vector3d(0.6, 0, 0.8));
  EXPECT_EQ(outer.SupportValue(), 0.8);
  EXPECT_EQ(outer.SupportPoint1(), low.on_1);
}

TEST(OuterApproximation, Nan_LeavesItAsItIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  dgd::OuterApproximation<double> outer;
  outer.Cut({0, 0, 1}, 2, {});
  outer.Cut({0, 0, 1}, nan, {});
  outer.Cut({nan, nan, nan}, 1, {});
  EXPECT_EQ(outer.Height(), 2);
  EXPECT_EQ(outer.Normal(), Vector3d(0, 0, 1));
}

}  // namespace
}  // namespace dgd_test
