// Cores with vertices against a linear program.
#include <gtest/gtest.h>

#include "support/checks.h"
#include "support/lp_oracle.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

constexpr CoreType kVertexTypes[] = {CoreType::kPoint, CoreType::kSegment, CoreType::kTriangle, CoreType::kBox,
                                     CoreType::kPolytope};

double ByLp(const ReferencePair& reference, const SolverPair<double>& pair) {
  return GrowthDistanceByLp(WorldVertices(reference.set_1, reference.pose_1), pair.Center1(),
                            WorldVertices(reference.set_2, reference.pose_2), pair.Center2());
}

/// The LP's answer lies between the bounds but for its own rounding and that of the world coordinates.
::testing::AssertionResult MatchesLp(const ReferencePair& reference, const dgd::Settings<double>& settings,
                                     double gap) {
  const SolverPair<double> pair(reference);
  const dgd::Result<double> result = pair.GrowthDistance(settings);
  const double expected = ByLp(reference, pair);
  constexpr double kSlack = 1e-11;
  const bool matches = result.status == dgd::Status::kOptimal && result.lower_bound <= expected * (1 + kSlack) &&
                       result.upper_bound >= expected * (1 - kSlack) && result.RelativeGap() <= gap;
  if (matches) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "status " << int(result.status) << " bounds " << result.lower_bound << " "
                                       << result.upper_bound << " LP " << expected << "\n"
                                       << reference.Dump();
}

TEST(LpOracle, KnownAnswers) {
  const auto box = [](double half) { return WorldVertices({.type = CoreType::kBox, .size = {half, half, half}}, {}); };
  auto moved = box(0.5);
  for (Eigen::Vector3d& vertex : moved) vertex += Eigen::Vector3d(3, 0.25, 0);
  EXPECT_NEAR(GrowthDistanceByLp(box(1), {0, 0, 0}, moved, {3, 0.25, 0}), 2, 1e-14);
  const std::vector<Eigen::Vector3d> point = {{0, 5, 0}};
  EXPECT_NEAR(GrowthDistanceByLp(box(2), {0, 0, 0}, point, point[0]), 2.5, 1e-14);
  // About a centre that is not the middle: 3 to the right wall at 1, from -1.
  const std::vector<Eigen::Vector3d> right = {{5, 0, 0}};
  EXPECT_NEAR(GrowthDistanceByLp(box(1), {-0.5, 0, 0}, right, right[0]), 5.5 / 1.5, 1e-14);
}

TEST(GrowthDistance, PolytopePairs_MatchLp) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(2500); ++i) {
    ReferencePair reference = RandomPair(random, CoreType::kPolytope, false, CoreType::kPolytope, false);
    ASSERT_TRUE(MatchesLp(reference, {}, dgd::kSqrtEpsilon<double>));
    ASSERT_TRUE(MatchesLp(reference, {.relative_tolerance = 1e-12}, 1e-12)) << "tight";
  }
}

TEST(GrowthDistance, RoundHulls_MatchLp) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(1000); ++i) {
    ReferencePair reference;
    reference.set_1 = RandomHull(random, 8 + random.Below(13), 0.5, 0);
    reference.set_2 = RandomHull(random, 8 + random.Below(200), 0.5, 0);
    PlaceRandomly(random, reference);
    ASSERT_TRUE(MatchesLp(reference, {}, dgd::kSqrtEpsilon<double>));
  }
}

TEST(GrowthDistance, VertexCores_MatchLp) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(2500); ++i) {
    const CoreType type_1 = kVertexTypes[random.Below(5)];
    const CoreType type_2 = kVertexTypes[type_1 >= CoreType::kBox ? random.Below(5) : 3 + random.Below(2)];
    const ReferencePair reference = RandomPair(random, type_1, false, type_2, false);
    ASSERT_TRUE(MatchesLp(reference, {}, dgd::kSqrtEpsilon<double>));
  }
}

}  // namespace
}  // namespace dgd_test
