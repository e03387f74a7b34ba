// Stopped after any number of iterations, the bounds hold; with every further one they get no worse.
#include <gtest/gtest.h>

#include "support/checks.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

/// The witness points reach the upper bound, and the normal proves the lower one, whatever the gap.
template <class S>
::testing::AssertionResult BoundsHold(const ReferencePair& reference, const SolverPair<S>& pair,
                                      const dgd::Result<S>& result) {
  const dgd::Certificate certificate = pair.Certify(result);
  const double extent = reference.Extent();
  const double proven = certificate.proven_lower_bound / double(result.lower_bound) - 1;
  const double rounding = Bounds<S>::Gap(pair, extent);
  const bool hold =
      IsFiniteAndOrdered(result) &&
      certificate.primal_infeasibility <= Bounds<S>::Infeasibility(pair, extent, double(result.upper_bound)) &&
      certificate.dual_infeasibility <= 1e-6 &&
      certificate.separation_error <= Bounds<S>::SeparationError(pair, extent) && std::abs(proven) <= rounding;
  if (hold) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "status " << int(result.status) << " iterations " << result.iterations << " "
                                       << IsFiniteAndOrdered(result).message() << " bounds " << result.lower_bound
                                       << " " << result.upper_bound << " primal infeasibility "
                                       << certificate.primal_infeasibility << " proven "
                                       << certificate.proven_lower_bound << "\n"
                                       << reference.Dump();
}

/// Of RayIntersection: portal refinement is for queries without a tight limit, and has no bounds after each step.
template <class S>
void CheckEveryIterationLimit(int pairs) {
  Random random(TestSeed());
  for (int i = 0; i < pairs; ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const ReferencePair reference = RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
    const SolverPair<S> pair(reference);
    const dgd::Result<S> last = pair.ObservedGrowthDistance({});
    S lower_bound = 0, upper_bound = std::numeric_limits<S>::infinity();
    for (int limit = 1; limit <= last.iterations; ++limit) {
      const dgd::Result<S> result = pair.ObservedGrowthDistance({.max_iterations = limit});
      ASSERT_EQ(result.status, limit < last.iterations ? dgd::Status::kIterationLimit : last.status);
      ASSERT_EQ(result.iterations, limit);
      ASSERT_TRUE(BoundsHold<S>(reference, pair, result));
      // No worse but for the order of two bounds that rounding alone keeps apart.
      ASSERT_GE(result.lower_bound, lower_bound * (1 - 2 * dgd::kEpsilon<S>)) << limit << "\n" << reference.Dump();
      ASSERT_LE(result.upper_bound, upper_bound) << limit << "\n" << reference.Dump();
      lower_bound = result.lower_bound;
      upper_bound = result.upper_bound;
    }
    ASSERT_EQ(upper_bound, last.upper_bound);
    ASSERT_EQ(lower_bound, last.lower_bound);
  }
}

TEST(GrowthDistance, EveryIterationLimit_LeavesValidMonotoneBoundsInDouble) {
  CheckEveryIterationLimit<double>(TestCount(10000));
}
TEST(GrowthDistance, EveryIterationLimit_LeavesValidMonotoneBoundsInFloat) {
  CheckEveryIterationLimit<float>(TestCount(3000));
}

// The tolerance is a promise for any value, not just for the default.
TEST(GrowthDistance, AnyRelativeTolerance_IsKept) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(5000); ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const ReferencePair reference = RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
    const SolverPair<double> pair(reference);
    const bool is_observed = random.Flip();
    int iterations = 1;
    for (const double tolerance : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      const dgd::Settings<double> settings{.relative_tolerance = tolerance};
      const dgd::Result<double> result =
          is_observed ? pair.ObservedGrowthDistance(settings) : pair.GrowthDistance(settings);
      ASSERT_EQ(result.status, dgd::Status::kOptimal) << tolerance << "\n" << reference.Dump();
      ASSERT_LE(result.RelativeGap(), tolerance * 1.0001);
      ASSERT_TRUE(BoundsHold<double>(reference, pair, result));
      // A portal refinement that is not certain where it ends is followed by another search.
      ASSERT_TRUE(!is_observed || result.iterations >= iterations);
      iterations = result.iterations;
    }
  }
}

}  // namespace
}  // namespace dgd_test
