// The hull of a ball and a point: what is found there is a convex combination of the two, and what is well inside is
// found.
#include "dgd/solver/ball_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dgd/solver/tolerances.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::solver_internal::FindInBallHull;

/// How far a point is beyond the hull of a ball about the origin and another point, metres: by the best of many of the
/// balls that make it.
double Beyond(const Eigen::Vector3d& point, const Eigen::Vector3d& farther, double inradius) {
  constexpr int kBalls = 2000;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kBalls; ++i) {
    const double share = double(i) / kBalls;
    least = std::min(least, (point - share * farther).norm() - (1 - share) * inradius);
  }
  return least;
}

template <class S>
void CheckRandomPoints() {
  const double rounding = 16 * double(dgd::kEpsilon<S>);
  Random random(TestSeed());
  int found = 0, inside = 0;
  const int count = TestCount(20000);
  for (int i = 0; i < count; ++i) {
    const double inradius = random.LogUniform(0.01, 1);
    const Eigen::Vector3d farther = random.UnitVector() * random.LogUniform(inradius, 30 * inradius);
    const Eigen::Vector3d end = farther * random.Uniform(0, 1.2) + random.Uniform(0, 1.2) * inradius * random.InCube();
    const auto point = FindInBallHull<S, 3>(end.cast<S>(), farther.cast<S>(), S(inradius));
    const double size = std::max(farther.norm(), end.norm());
    const double beyond = Beyond(end, farther, inradius);
    inside += beyond < 0;
    if (beyond < -0.01 * size) {
      ASSERT_TRUE(point) << end.transpose();
    }
    if (!point) continue;
    ++found;
    ASSERT_LE(beyond, rounding * size);
    const auto share = double(point->share);
    ASSERT_GE(share, 0);
    ASSERT_LE(share, 1);
    const Eigen::Vector3d in_ball = point->inside.template cast<double>();
    ASSERT_LE(in_ball.norm(), (1 - share) * inradius + rounding * size);
    ASSERT_LE((share * farther + in_ball - end).norm(), rounding * size);
  }
  EXPECT_GT(found, 0.9 * inside);
  EXPECT_LT(inside, 0.9 * count);
  EXPECT_GT(inside, 0.3 * count);
}

TEST(BallHull, RandomPoints_AreFoundWhereTheyAreInside) {
  CheckRandomPoints<double>();
  CheckRandomPoints<float>();
}

TEST(BallHull, PointInTheBall_IsFound) {
  // Of no account are directions, and a point that is no farther than the ball.
  for (const double reach : {0.5, 1.0, 1.5}) {
    const auto point = FindInBallHull<double, 2>({0.3, 0.4}, {-reach, 0}, 1.0);
    ASSERT_TRUE(point) << reach;
    EXPECT_LE(point->inside.norm(), 1 - point->share);
  }
}

TEST(BallHull, Surface_IsNotDecided) {
  const Eigen::Vector3d farther(0, 0, 2);
  EXPECT_FALSE((FindInBallHull<double, 3>({0, 0, 2}, farther, 1.0)));
  EXPECT_FALSE((FindInBallHull<double, 3>({0, 0, 1.9999}, farther, 1.0)));
  EXPECT_FALSE((FindInBallHull<double, 3>({0, 0, -1}, farther, 1.0)));
  EXPECT_TRUE((FindInBallHull<double, 3>({0, 0, 1.99}, farther, 1.0)));
}

TEST(BallHull, NoNumber_IsNotInside) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE((FindInBallHull<double, 3>({kNan, 0, 0}, {0, 0, 2}, 1.0)));
  EXPECT_FALSE((FindInBallHull<double, 3>({0, 0, 0}, {kNan, 0, 2}, 1.0)));
}

}  // namespace
}  // namespace dgd_test
