// Times of impact of random motions of pairs of all types, against the motion taken in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "support/pairs/random_pair.h"

namespace dgd_test {
namespace {

constexpr LengthRange kLengths{0.02, 1};

PoseNumbers ToNumbers(const dgd::Pose<double>& pose) { return {pose.rotation, pose.translation}; }

/// Set 2 on its way to about where set 1 is, or past it, both turning in half of the cases by up to a radian or so.
std::array<dgd::Motion<double>, 2> RandomMotions(Random& random, const PairNumbers& numbers,
                                                 const AnyPair<double, 3>& pair) {
  std::array<dgd::Motion<double>, 2> motions;
  motions[0].start = {numbers.pose_1.rotation, numbers.pose_1.translation};
  motions[1].start = {numbers.pose_2.rotation, numbers.pose_2.translation};
  const Eigen::Vector3d way = pair.Center(Which::kFirst) - pair.Center(Which::kSecond);
  motions[1].translation = random.Uniform(0.2, 2) * way + random.Uniform(0, 0.7) * pair.Extent() * random.UnitVector();
  const bool turns = random.Flip();
  for (dgd::Motion<double>& motion : motions) {
    if (turns) motion.rotation = random.Uniform(0, 1.5) * random.UnitVector();
    if (turns && random.Flip()) motion.center = random.Uniform(0, 1) * random.UnitVector();
  }
  return motions;
}

struct Along {
  std::array<dgd::Motion<double>, 2> motions;

  dgd::Result<double> GrowthAt(double time, AnyPair<double, 3>& pair) const {
    pair.MoveTo(ToNumbers(motions[0].At(time)), ToNumbers(motions[1].At(time)));
    return pair.GrowthDistance({});
  }
};

TEST(TimeOfImpact, RandomMotions_AreNeverLateAndHitWhenTheyTouch) {
  constexpr double kTime = 1e-6;
  constexpr int kSteps = 24;
  const int count = TestCount(20000, 300);
  Random random(TestSeed());
  int hits = 0, passes = 0, undecided = 0, grazing = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    PairNumbers numbers = RandomPairOfAnyTypes(random, kLengths);
    Place(random, random.Flip() ? Placement::kFarApart : Placement::kGeneric, numbers);
    AnyPair<double, 3> pair(numbers);
    const Along along{RandomMotions(random, numbers, pair)};
    const dgd::TimeOfImpactResult<double> result = pair.TimeOfImpact(along.motions[0], along.motions[1]);
    SCOPED_TRACE("motion " + std::to_string(i) + ", status " + std::to_string(int(result.status)) + ", time " +
                 std::to_string(result.time) + "\n" + Dump(numbers));
    if (result.status == dgd::Status::kColliding) {
      EXPECT_EQ(result.time, 0);
      EXPECT_LT(along.GrowthAt(0, pair).upper_bound, 1 + 1e-9);
      continue;
    }
    // Apart at every earlier time.
    for (int step = 0; step <= kSteps; ++step) {
      const double time = result.time * step / kSteps;
      const dgd::Result<double> growth = along.GrowthAt(time, pair);
      const bool is_impact = step == kSteps && result.status == dgd::Status::kTouching;
      const double separation = SeparationAlong(pair, is_impact ? result.normal : growth.normal);
      EXPECT_GT(separation, is_impact && result.time == 0 ? -1e-9 : 0) << "at " << time;
    }
    switch (result.status) {
      case dgd::Status::kTouching: {
        ++hits;
        const bool overlaps = along.GrowthAt(result.time + kTime, pair).upper_bound < 1;
        grazing += !overlaps;
        if (!overlaps) {
          const dgd::Result<double> growth = along.GrowthAt(result.time, pair);
          const dgd::SignedDistanceResult<double> distance = pair.SignedDistance(growth);
          EXPECT_LE((distance.witness_2 - distance.witness_1).norm(), 1e-6 * pair.Extent());
        }
        break;
      }
      case dgd::Status::kSeparated:
        ++passes;
        break;
      default:
        ++undecided;
    }
  }
  std::printf("%d motions: %d hit, of these %d graze; %d pass; %d undecided\n", count, hits, grazing, passes,
              undecided);
  EXPECT_GE(hits, 0.2 * count);
  EXPECT_GE(passes, 0.1 * count);
  EXPECT_LE(grazing, 0.001 * count);
  EXPECT_LE(undecided, 0.001 * count);
}

}  // namespace
}  // namespace dgd_test
