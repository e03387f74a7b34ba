#include "dgd/solver/minkowski_difference.h"

#include <gtest/gtest.h>

#include "dgd/shapes/box.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

using dgd::Vector3;

template <class S>
void CheckFrame(const Vector3<S>& axis) {
  const dgd::Matrix3<S> frame = dgd::FrameAlong<S>(axis);
  EXPECT_NEAR((frame.transpose() * frame - dgd::Matrix3<S>::Identity()).norm(), 0, 16 * dgd::kEpsilon<S>)
      << axis.transpose();
  EXPECT_NEAR(frame.determinant(), 1, 16 * dgd::kEpsilon<S>);
  EXPECT_EQ(frame.col(2), axis);
}

template <class S>
void CheckFrames() {
  for (int k = 0; k < 3; ++k) {
    for (const S sign : {S(1), S(-1)}) CheckFrame<S>(sign * Vector3<S>::Unit(k));
  }
  CheckFrame<S>({S(-0.0), 0, -1});
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    CheckFrame<S>(random.UnitVector().cast<S>().normalized());
    // Where z is about -1 and its sign decides.
    for (const double z : {-1.0, 0.0, 1.0}) {
      const Eigen::Vector3d near(random.LogUniform(1e-20, 1e-3), random.LogUniform(1e-20, 1e-3), z);
      CheckFrame<S>(near.cast<S>().normalized());
    }
  }
}
TEST(FrameAlong, AnyAxis_GivesARotation) {
  CheckFrames<double>();
  CheckFrames<float>();
}

TEST(MinkowskiDifference, Support_IsTheDifferenceOfTheSetsSupportPoints) {
  Random random(TestSeed());
  for (int i = 0; i < 200; ++i) {
    ReferencePair reference{
        RandomSet(random, CoreType::kPolytope, i % 2 == 0), RandomSet(random, CoreType::kBox, i % 4 < 2), {}, {}};
    PlaceRandomly(random, reference);
    const dgd::RoundedSet set_1{dgd::Polytope<double>(reference.set_1.points), reference.set_1.radius};
    const dgd::RoundedSet set_2{dgd::Box<double>(reference.set_2.size), reference.set_2.radius};
    const dgd::Pose<double> pose_1{reference.pose_1.rotation, reference.pose_1.translation};
    const dgd::Pose<double> pose_2{reference.pose_2.rotation, reference.pose_2.translation};
    const dgd::MinkowskiDifference difference(set_1, pose_1, set_2, pose_2);
    const Eigen::Vector3d p = difference.Center2() - difference.Center1();
    // p has the rounding of the centres, which the length has not.
    const double rounding = 1e-15 * (difference.Center1().norm() + difference.Center2().norm());
    EXPECT_NEAR(difference.CenterDistance(), p.norm(), rounding);
    EXPECT_NEAR(difference.DirectionToWorld(Eigen::Vector3d::UnitZ()).dot(p), p.norm(), 10 * rounding);
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d normal = random.UnitVector();
      const Eigen::Vector3d normal_w = difference.DirectionToWorld(normal);
      const dgd::DifferencePoint<double> support = difference.Support(normal, normal);
      const double value = normal.dot(support.point) + difference.ConvexRadius();
      // By Prop. 1: the support value of C1 - C2 + p, with the centres at the origin.
      EXPECT_NEAR(normal_w.dot(p) - value, reference.SeparationAlong(normal_w), 1e-13 * reference.Extent());
      const Eigen::Vector3d on_2 = support.on_1 - support.point;
      const Eigen::Vector3d world_1 = difference.World1(support.on_1, normal);
      const Eigen::Vector3d world_2 = difference.World2(on_2, normal);
      EXPECT_NEAR(normal_w.dot(world_1), Height(reference.set_1, reference.pose_1, normal_w), 1e-13 * kLargest * 4);
      EXPECT_NEAR(-normal_w.dot(world_2), Height(reference.set_2, reference.pose_2, -normal_w), 1e-13 * kLargest * 4);
      ASSERT_TRUE(difference.HasFeatures(support.feature_1, support.feature_2));
      const dgd::DifferencePoint<double> again = difference.FromVertices(support.feature_1, support.feature_2);
      EXPECT_EQ(again.point, support.point);
      EXPECT_EQ(again.on_1, support.on_1);
    }
    EXPECT_FALSE(difference.HasFeatures(dgd::kNoFeature, 0));
    EXPECT_FALSE(difference.HasFeatures(0, 8));
  }
}

TEST(MinkowskiDifference, Radii_AreRoundingFromAboutEightDigitsOn) {
  const auto difference_of = [](double radius) {
    const dgd::RoundedSet box{dgd::Box<double>(Eigen::Vector3d(1, 1, 1)), radius};
    const dgd::RoundedSet point{dgd::Point<double>(), 0.0};
    const dgd::MinkowskiDifference difference(box, {}, point, {dgd::Matrix3<double>::Identity(), {3, 0, 0}});
    return std::pair(difference.ConvexRadius(),
                     difference.Support(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()).point.z());
  };
  EXPECT_EQ(difference_of(0), std::pair(0.0, 1.0));
  EXPECT_EQ(difference_of(0.5), std::pair(0.5, 1.0));
  // Below kMinConvexRadius it is part of the support point.
  EXPECT_EQ(difference_of(1e-9).first, 0);
  EXPECT_NEAR(difference_of(1e-9).second, 1 + 1e-9, 1e-15);
}

}  // namespace
}  // namespace dgd_test
