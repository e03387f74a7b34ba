// Of finite sets in finite poses, no query meets a number that is none, divides by zero, or overflows: of all types of
// sets, apart, touching, aligned and overlapping, cold and warm, in double and float.
#include <gtest/gtest.h>

#include <string>

#include "support/floating_point_traps.h"
#include "support/pairs/random_pair.h"

namespace dgd_test {
namespace {

/// Asks each pair in all ways, under traps.
template <class S, int L>
void AskAll(Random& random, const PairNumbers& numbers) {
  const AnyPair<S, L> pair(numbers);
  AnyPair<S, L> moved(numbers);
  moved.MoveTo(numbers.pose_1, MovedALittle(random, numbers.pose_2, L, 0.01, pair.Extent()));
  dgd::WarmStart<S, L> start, yes_no_start;
  const FloatingPointTraps traps;
  for (const AnyPair<S, L>* asked : {&pair, static_cast<const AnyPair<S, L>*>(&moved)}) {
    const dgd::Result<S, L> result = asked->GrowthDistance({}, &start);
    asked->DetectCollision({}, &yes_no_start);
    asked->GrowthDistance({.separation_limit = S(0.01)}, &start);
    if constexpr (L == 3) asked->SignedDistance(result, &start);
  }
}

template <class S>
void AskRandomPairs(int count) {
  Random random(TestSeed());
  for (int i = 0; i < count; ++i) {
    PairNumbers numbers = RandomPairOfAnyTypes(random, {0.01, 1});
    Place(random, static_cast<Placement>(random.Below(kPlacementCount)), numbers);
    AskAll<S, 3>(random, sizeof(S) == sizeof(float) ? RoundedToFloat(numbers) : numbers);
  }
}

TEST(FloatingPointExceptions, RandomPairs_RaiseNoneInDouble) { AskRandomPairs<double>(TestCount(50000, 1000)); }
TEST(FloatingPointExceptions, RandomPairs_RaiseNoneInFloat) { AskRandomPairs<float>(TestCount(25000, 1000)); }

}  // namespace
}  // namespace dgd_test
