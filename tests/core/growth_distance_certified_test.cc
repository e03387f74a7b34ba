// Random pairs of all type combinations, with and without radii, each answer certified.
#include <gtest/gtest.h>

#include "support/checks.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

template <class S>
void CertifyAllTypePairs(int pairs) {
  constexpr int kCombinations = static_cast<int>(kCoreTypes.size() * kCoreTypes.size() * 4);
  const int pairs_each = (pairs + kCombinations - 1) / kCombinations;
  Random random(TestSeed());
  int count = 0, hits = 0, failures = 0;
  for (int i = 0; i < pairs_each; ++i) {
    for (const CoreType type_1 : kCoreTypes) {
      for (const CoreType type_2 : kCoreTypes) {
        for (int rounded = 0; rounded < 4; ++rounded) {
          const ReferencePair reference = RandomPair(random, type_1, (rounded & 1) != 0, type_2, (rounded & 2) != 0);
          const SolverPair<S> pair(reference);
          const dgd::Result<S> result = pair.GrowthDistance();
          ++count;
          hits += result.upper_bound <= 1;
          const ::testing::AssertionResult certified = IsCertified<S>(reference, pair, result);
          failures += !certified;
          // Ten printed cases are enough to work on.
          if (!certified && failures <= 10) ADD_FAILURE() << certified.message();
        }
      }
    }
  }
  EXPECT_EQ(failures, 0) << "of " << count;
  EXPECT_GE(hits, 0.3 * count);
  EXPECT_LE(hits, 0.7 * count);
  std::printf("%d pairs, %d of them hits\n", count, hits);
}

TEST(GrowthDistance, RandomPairs_AreCertifiedInDouble) { CertifyAllTypePairs<double>(TestCount(kUsualPairs)); }
TEST(GrowthDistance, RandomPairs_AreCertifiedInFloat) { CertifyAllTypePairs<float>(TestCount(kUsualPairs / 5)); }

// Where it matters most: pairs scaled to touch exactly but for one part in 10^3 to 10^12, either way.
template <class S>
void CertifyTouchingPairs(int pairs, S closest) {
  Random random(TestSeed());
  int hits = 0;
  for (int i = 0; i < pairs; ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    ReferencePair reference = RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
    const SolverPair<double> apart(reference);
    const double growth_distance = apart.GrowthDistance().GrowthDistance();
    const Eigen::Vector3d p = apart.Center2() - apart.Center1();
    const double off = (random.Flip() ? 1 : -1) * random.LogUniform(double(closest), 1e-3);
    reference.pose_2.translation += ((1 + off) / growth_distance - 1) * p;
    const SolverPair<S> pair(reference);
    const dgd::Result<S> result = pair.GrowthDistance();
    EXPECT_TRUE(IsCertified<S>(reference, pair, result));
    EXPECT_NEAR(double(result.GrowthDistance()), 1 + off, 4 * Bounds<S>::Gap(pair, reference.Extent()));
    hits += result.GrowthDistance() <= 1;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(hits, 0.3 * pairs);
  EXPECT_LE(hits, 0.7 * pairs);
}

TEST(GrowthDistance, TouchingPairs_AreCertifiedInDouble) { CertifyTouchingPairs<double>(TestCount(20000), 1e-12); }
TEST(GrowthDistance, TouchingPairs_AreCertifiedInFloat) { CertifyTouchingPairs<float>(TestCount(5000), 1e-6F); }

}  // namespace
}  // namespace dgd_test
