#include "dgd/solver/ray_bounds.h"

#include <gtest/gtest.h>

#include <limits>

#include "dgd/shapes/box.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

/// Two boxes of 2 m whose centres are 4 m apart.
class RayBounds : public testing::Test {
 protected:
  using Set = dgd::RoundedSet<dgd::Box<double>>;
  using Difference = dgd::MinkowskiDifference<Set, Set>;

  const Set box_{dgd::Box<double>({1, 1, 1})};
  const dgd::Pose<double> pose_1_{};
  const dgd::Pose<double> pose_2_{Eigen::Matrix3d::Identity(), {0, 0, 4}};
  const Difference difference_{box_, pose_1_, box_, pose_2_};
  const dgd::Settings<double> settings_{};
  dgd::RayBounds<Difference> bounds_{difference_, settings_, 1};
};

TEST_F(RayBounds, BeforeTheFirstPlane_AreInfinite) {
  EXPECT_EQ(bounds_.Outer(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bounds_.LowerBound(), 0);
  EXPECT_EQ(bounds_.UpperBound(), 4);
  EXPECT_FALSE(bounds_.Verdict(dgd::QueryMode::kDistance));
  EXPECT_FALSE(bounds_.Verdict(dgd::QueryMode::kCollision));
}

TEST_F(RayBounds, Planes_TheLowestIsKept) {
  bounds_.LowerOuter({0, 0, 1}, 3, {4, 5, 6});
  bounds_.LowerOuter({3, 0, 4}, 2, {1, 2, 1});
  bounds_.LowerOuter({0, 0, 1}, 2.5, {4, 5, 6});
  EXPECT_EQ(bounds_.Outer(), 2);
  EXPECT_EQ(bounds_.OuterDirection(), Vector3d(3, 0, 4));
  EXPECT_NEAR((bounds_.NormalInFrame() - Vector3d(0.6, 0, 0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR(bounds_.Separation(), 0.8 * (4 - 2), 1e-15);
  EXPECT_NEAR((bounds_.PointBetween() - Vector3d(1.48, 2, 1.64)).norm(), 0, 1e-15);
}

TEST_F(RayBounds, Nan_LeavesThemAsTheyAre) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bounds_.LowerOuter({0, 0, 1}, 3, Vector3d::Zero());
  bounds_.LowerOuter({nan, nan, nan}, nan, Vector3d::Zero());
  bounds_.RaiseInner(nan);
  EXPECT_EQ(bounds_.Outer(), 3);
  EXPECT_EQ(bounds_.Inner(), 1);
  EXPECT_EQ(bounds_.OuterDirection(), Vector3d(0, 0, 1));
}

TEST_F(RayBounds, Verdict_IsTheFirstThatTheBoundsAllow) {
  bounds_.LowerOuter({0, 0, 1}, 5, Vector3d::Zero());
  EXPECT_FALSE(bounds_.Verdict(dgd::QueryMode::kCollision));
  bounds_.RaiseInner(4.5);
  EXPECT_EQ(bounds_.Verdict(dgd::QueryMode::kCollision), dgd::Status::kColliding);
  EXPECT_FALSE(bounds_.Verdict(dgd::QueryMode::kDistance));
  bounds_.RaiseInner(5);
  EXPECT_EQ(bounds_.Verdict(dgd::QueryMode::kDistance), dgd::Status::kOptimal);
}

TEST_F(RayBounds, PlaneBetweenTheSets_IsAVerdictBeyondTheLimit) {
  dgd::Settings<double> limited;
  limited.separation_limit = 1.5;
  dgd::RayBounds<Difference> bounds(difference_, limited, 1);
  bounds.LowerOuter({0, 0, 1}, 3, Vector3d::Zero());
  EXPECT_EQ(bounds.Verdict(dgd::QueryMode::kCollision), dgd::Status::kSeparated);
  EXPECT_FALSE(bounds.Verdict(dgd::QueryMode::kDistance));
  bounds.LowerOuter({0, 0, 1}, 2, Vector3d::Zero());
  EXPECT_EQ(bounds.Verdict(dgd::QueryMode::kDistance), dgd::Status::kSeparated);
}

}  // namespace
}  // namespace dgd_test
