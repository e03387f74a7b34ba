// Analytic answers, and a brute-force check over many points of both features.
#include "simulation/feature_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/random.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

TEST(FeatureDistanceTest, CrossingSegments_AtTheirHeight) {
  const Connection found =
      Connect({Vector3d(-1, 0, 0), Vector3d(1, 0, 0)}, {Vector3d(0.5, -1, 2), Vector3d(0.5, 1, 2)});
  EXPECT_DOUBLE_EQ(found.distance, 2);
  EXPECT_LT((found.on_first - Vector3d(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_LT((found.on_second - Vector3d(0.5, 0, 2)).norm(), 1e-15);
}

TEST(FeatureDistanceTest, ParallelSegments_SideBySideAndInARow) {
  const Segment unit = {Vector3d(0, 0, 0), Vector3d(1, 0, 0)};
  EXPECT_DOUBLE_EQ(Connect(unit, {Vector3d(0.5, 3, 0), Vector3d(7, 3, 0)}).distance, 3);
  EXPECT_DOUBLE_EQ(Connect(unit, {Vector3d(3, 0, 0), Vector3d(5, 0, 0)}).distance, 2);
  EXPECT_DOUBLE_EQ(Connect(unit, {Vector3d(0.2, 0, 0), Vector3d(0.4, 0, 0)}).distance, 0);
}

TEST(FeatureDistanceTest, SegmentsWithoutLength_ArePoints) {
  const Segment point = {Vector3d(0, 3, 4), Vector3d(0, 3, 4)};
  EXPECT_DOUBLE_EQ(Connect(point, {Vector3d::Zero(), Vector3d::Zero()}).distance, 5);
  EXPECT_DOUBLE_EQ(Connect(point, {Vector3d(-1, 0, 4), Vector3d(1, 0, 4)}).distance, 3);
}

TEST(FeatureDistanceTest, RandomSegments_NoSampleIsNearer) {
  Random random(11, 0);
  const auto corner = [&] { return random.InBox(Vector3d::Constant(-1), Vector3d::Constant(1)); };
  for (int trial = 0; trial < 200; ++trial) {
    Segment first, second;
    for (Vector3d& end : first) end = corner();
    for (Vector3d& end : second) end = corner();
    const Connection found = Connect(first, second);
    EXPECT_NEAR((found.on_second - found.on_first).norm(), found.distance, 1e-14);

    constexpr int kSteps = 60;
    double nearest = 1e9;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const double s = static_cast<double>(i) / kSteps, t = static_cast<double>(j) / kSteps;
        nearest = std::min(nearest, ((1 - s) * first[0] + s * first[1] - (1 - t) * second[0] - t * second[1]).norm());
      }
    }
    EXPECT_LE(found.distance, nearest + 1e-14);
    EXPECT_GE(found.distance, nearest - 3.5 / kSteps);  // Half a step along each segment, of length 3.5 at most.
  }
}

const Triangle kTriangle = {Vector3d(0, 0, 1), Vector3d(2, 0, 1), Vector3d(0, 2, 1)};

TEST(FeatureDistanceTest, PointAboveTriangle_AtItsHeight) {
  const auto found = ConnectToInside(Vector3d(0.5, 0.5, 4), kTriangle, Vector3d::UnitZ());
  ASSERT_TRUE(found.has_value());
  EXPECT_DOUBLE_EQ(found->distance, 3);
  EXPECT_LT((found->on_second - Vector3d(0.5, 0.5, 1)).norm(), 1e-15);
}

TEST(FeatureDistanceTest, PointBesideOrBelowTriangle_HasNoConnectionToItsInside) {
  EXPECT_FALSE(ConnectToInside(Vector3d(2, 2, 4), kTriangle, Vector3d::UnitZ()).has_value());
  EXPECT_FALSE(ConnectToInside(Vector3d(-0.1, 0.5, 4), kTriangle, Vector3d::UnitZ()).has_value());
  EXPECT_FALSE(ConnectToInside(Vector3d(0.5, 0.5, 0), kTriangle, Vector3d::UnitZ()).has_value());
}

// The rim belongs to the inside: a flat face of two triangles must have no gap along its diagonal.
TEST(FeatureDistanceTest, PointAboveTheRim_IsConnected) {
  EXPECT_TRUE(ConnectToInside(Vector3d(1, 1, 4), kTriangle, Vector3d::UnitZ()).has_value());
  EXPECT_TRUE(ConnectToInside(Vector3d(0, 0, 4), kTriangle, Vector3d::UnitZ()).has_value());
}

}  // namespace
}  // namespace dgd_demos
