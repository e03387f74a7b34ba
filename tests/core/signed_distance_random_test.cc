// The signed distance of random pairs of all types, skewed, touching and aligned ones among them: what it says along
// its normal is true, no other normal is better, and the witness points are that far apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/pairs/random_pair.h"

namespace dgd_test {
namespace {

PairNumbers RandomlyPlacedPair(Random& random) {
  PairNumbers pair = RandomPairOfAnyTypes(random, {0.02, 1});
  Place(random, static_cast<Placement>(random.Below(kPlacementCount)), pair);
  return pair;
}

/// A plain box does not tell its vertices apart.
bool IsKnownPolytope(SetType type) { return !InfoOf(type).is_curved && type != SetType::kPlainBox; }

/// Of random unit vectors, near `normal` and anywhere.
template <class S>
double BestOfOtherNormals(Random& random, const AnyPair<S, 3>& pair, const Eigen::Vector3d& normal) {
  double best = -std::numeric_limits<double>::infinity();
  for (const double distance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    for (int i = 0; i < 6; ++i) {
      best = std::max(best, SeparationAlong(pair, (normal + distance * random.UnitVector()).normalized()));
    }
  }
  for (int i = 0; i < 60; ++i) best = std::max(best, SeparationAlong(pair, random.UnitVector()));
  return best;
}

template <class S>
void CheckRandomPairs(int count) {
  constexpr double kEpsilon = double(dgd::kEpsilon<S>), kGap = double(dgd::kSqrtEpsilon<S>);
  Random random(TestSeed());
  int overlaps = 0, differing = 0, unfinished = 0, unfinished_polytopes = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    const PairNumbers any_numbers = RandomlyPlacedPair(random);
    const PairNumbers numbers = sizeof(S) == sizeof(float) ? RoundedToFloat(any_numbers) : any_numbers;
    const AnyPair<S, 3> pair(numbers);
    dgd::WarmStart<S> warm_start;
    const dgd::Result<S> growth = pair.GrowthDistance({}, &warm_start);
    const dgd::SignedDistanceResult<S> result = pair.SignedDistance(growth, &warm_start);
    const bool is_polytope = IsKnownPolytope(numbers.set_1.type) && IsKnownPolytope(numbers.set_2.type);
    const double size = pair.Extent();
    const double reach = size + (pair.Center(Which::kSecond) - pair.Center(Which::kFirst)).norm() +
                         pair.Center(Which::kFirst).cwiseAbs().maxCoeff();
    const double rounding = 64 * kEpsilon * reach;
    SCOPED_TRACE("pair " + std::to_string(i) + "\n" + Dump(numbers));

    EXPECT_GE(double(result.separation - growth.separation), -rounding) << int(growth.status);
    EXPECT_LE(double(result.separation), double(result.upper_bound) + rounding);
    const double other = BestOfOtherNormals(random, pair, result.normal.template cast<double>().normalized());
    EXPECT_LE(other, double(result.upper_bound) + rounding);

    overlaps += result.separation < 0;
    if (result.separation < 0 && !is_polytope && result.status == dgd::Status::kOptimal) {
      // The search goes another way from the other set: an answer that is not the best of all shows as a difference.
      const dgd::SignedDistanceResult<S> swapped =
          AnyPair<S, 3>({numbers.set_2, numbers.set_1, numbers.pose_2, numbers.pose_1}).SignedDistance({});
      const double difference = std::abs(double(swapped.separation - result.separation));
      if (swapped.status == dgd::Status::kOptimal) {
        differing += difference > 1e-4 * std::abs(double(result.separation)) + kGap * size + rounding;
      }
    }
    const bool is_finished = result.status == dgd::Status::kOptimal;
    unfinished += !is_finished;
    unfinished_polytopes += is_polytope && !is_finished;
    const dgd::SignedDistanceCertificate certificate = pair.Certify(result);
    EXPECT_LE(certificate.dual_infeasibility, 16 * kEpsilon);
    EXPECT_LE(certificate.separation_error, rounding);
    if (!is_finished) continue;
    const double gap = is_polytope ? rounding : kGap * size + rounding;
    // The root of the gap is how far a normal and the points are off along a curve.
    EXPECT_TRUE(certificate.Holds(2 * gap, 4 * std::sqrt(gap * reach)))
        << "primal infeasibility " << certificate.primal_infeasibility << " m, connection error "
        << certificate.connection_error << " m, neighbour's gain " << certificate.neighbour_gain << " m; at most "
        << 2 * gap << " m";
    EXPECT_LE(double(result.upper_bound - result.separation),
              result.separation < 0 && !is_polytope ? 0.01 * size : 2 * gap);
  }
  EXPECT_GE(overlaps, 0.3 * count);
  EXPECT_LE(overlaps, 0.8 * count);
  EXPECT_LE(differing, 0.001 * count);
  EXPECT_LE(unfinished, 0.0015 * count);
  EXPECT_LE(unfinished_polytopes, 0.002 * count);
  std::printf("%d pairs, %d of them overlapping; %d not optimal, %d of these polytopes; %d otherwise when swapped\n",
              count, overlaps, unfinished, unfinished_polytopes, differing);
}

TEST(SignedDistance, RandomPairs_NoOtherNormalIsBetterInDouble) { CheckRandomPairs<double>(TestCount(20000, 200)); }
TEST(SignedDistance, RandomPairs_NoOtherNormalIsBetterInFloat) { CheckRandomPairs<float>(TestCount(5000, 100)); }

}  // namespace
}  // namespace dgd_test
