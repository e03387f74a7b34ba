// IE against the certificate and the solver, on the benchmarks' classes of pairs.
#include "bench/textbook/internal_expanding.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/textbook/random_textbook_pair.h"

namespace dgd_bench {
namespace {

dgd::Result<double> Ask(const TextbookPair& pair, double tolerance = dgd::kSqrtEpsilon<double>) {
  return InternalExpanding(pair.Set1(), pair.Pose1(), pair.Set2(), pair.Pose2(), tolerance);
}

void CertifyClass(const char* pair_class, int pairs, int poses_each) {
  dgd_test::Random random(dgd_test::TestSeed());
  const Meshes meshes = EllipsoidMeshes(random);
  int overlaps = 0;
  for (int i = 0; i < pairs; ++i) {
    TextbookPair pair(ClassOf(pair_class).draw_sets(random, meshes));
    for (int j = 0; j < poses_each; ++j) {
      const PairPoses poses = DrawNearPoses(random, pair.Extent());
      pair.MoveTo(poses.pose_1, poses.pose_2);
      const dgd::Result<double> result = Ask(pair);
      overlaps += result.upper_bound <= 1;
      ASSERT_TRUE(pair.IsCertified(result, {.gap = 2e-8, .primal = 1e-9}));
    }
  }
  EXPECT_TRUE(IsBalanced(overlaps, pairs * poses_each)) << overlaps;
}

TEST(InternalExpanding, CurvedPairs_AreCertified) { CertifyClass("curved", dgd_test::TestCount(2000), 5); }
TEST(InternalExpanding, RoundedHulls_AreCertified) { CertifyClass("rounded-hulls", dgd_test::TestCount(1000), 5); }
TEST(InternalExpanding, SharpHulls_AreCertified) { CertifyClass("sharp-hulls", dgd_test::TestCount(1000), 5); }
TEST(InternalExpanding, Meshes_AreCertified) { CertifyClass("meshes", 10, dgd_test::TestCount(200)); }
TEST(InternalExpanding, SmoothSupportFunctions_AreCertified) { CertifyClass("dsf", dgd_test::TestCount(50), 5); }

dgd_test::PairNumbers BoxAndBall() {
  dgd_test::PairNumbers numbers;
  numbers.set_1.type = dgd_test::SetType::kBox;
  numbers.set_1.lengths = {1, 2, 3};
  numbers.set_2.type = dgd_test::SetType::kPoint;
  numbers.set_2.radius = 0.5;
  numbers.pose_2.translation = {3, 0.5, -0.4};
  return numbers;
}

// Along x, between the box's face at 1 and the ball: 3 / (1 + 0.5).
TEST(InternalExpanding, BoxAndBall_AsByHand) {
  const dgd::Result<double> result = Ask(TextbookPair(BoxAndBall()));
  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_NEAR(result.lower_bound, 2, 1e-7);
  EXPECT_NEAR(result.upper_bound, 2, 1e-7);
  EXPECT_NEAR(result.separation, 1.5, 1e-7);
  EXPECT_NEAR(result.normal.x(), 1, 1e-7);
  EXPECT_NEAR(result.witness_1.x(), 1, 1e-7);
  EXPECT_NEAR(result.witness_2.x(), 2.5, 1e-7);
}

TEST(InternalExpanding, Tolerance_BoundsTheGapAndCostsIterations) {
  dgd_test::Random random(dgd_test::TestSeed());
  int most_at_loosest = 0, most_at_tightest = 0;
  for (int i = 0; i < 200; ++i) {
    TextbookPair pair(ClassOf("curved").draw_sets(random, {}));
    const PairPoses poses = DrawNearPoses(random, pair.Extent());
    pair.MoveTo(poses.pose_1, poses.pose_2);
    int last_iterations = 0;
    most_at_loosest = std::max(most_at_loosest, Ask(pair, 1e-3).iterations);
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const dgd::Result<double> result = Ask(pair, tolerance);
      ASSERT_TRUE(pair.IsCertified(result, {.gap = tolerance + 1e-14, .primal = 1e-7}));
      ASSERT_GE(result.iterations, last_iterations);
      last_iterations = result.iterations;
    }
    most_at_tightest = std::max(most_at_tightest, last_iterations);
  }
  EXPECT_GT(most_at_tightest, 2 * most_at_loosest);
}

// What no arithmetic reaches ends with bounds that hold.
TEST(InternalExpanding, ToleranceBelowRounding_IterationLimitWithBounds) {
  const TextbookPair pair(BoxAndBall());
  const dgd::Result<double> result = Ask(pair, -1);
  EXPECT_EQ(result.status, dgd::Status::kIterationLimit);
  EXPECT_LE(result.iterations, 100);
  EXPECT_LE(result.lower_bound, 2 + 1e-12);
  EXPECT_GE(result.upper_bound, 2 - 1e-12);
  EXPECT_LE(pair.Certify(result).relative_gap, 1e-7);
}

}  // namespace
}  // namespace dgd_bench
