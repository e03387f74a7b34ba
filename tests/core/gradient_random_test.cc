// Gradients of random pairs of all types, in space and in the plane, against central differences of the growth distance
// and the signed distance in extended precision; and the flags that say where there is no derivative.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <variant>

#include "dgd/gradient.h"
#include "support/pairs/extended_distance.h"
#include "support/pairs/make_set.h"
#include "support/pairs/random_pair.h"

namespace dgd_test {
namespace {

enum class Kind { kGrowthDistance, kSignedDistance };

/// Sets that name no features are solved by cutting planes: to the root of double's last digit in the normal.
bool IsPlain(SetType type) {
  return type == SetType::kPlainBox || type == SetType::kSuperellipsoid || type == SetType::kSuperellipse;
}

template <int L>
PairNumbers RandomPairIn(Random& random) {
  constexpr LengthRange kLengths{0.02, 1};
  if constexpr (L == 3) {
    return RandomPairOfAnyTypes(random, kLengths);
  } else {
    PairNumbers pair;
    do {
      for (SetNumbers* set : {&pair.set_1, &pair.set_2}) {
        SetType type;
        do type = static_cast<SetType>(random.Below(static_cast<int>(kSetTypeCount)));
        while (InfoOf(type).dimension != 2);
        *set = RandomSetOf(random, type, kLengths, random.Flip());
      }
    } while (!pair.set_1.HasInterior() && !pair.set_2.HasInterior());
    return pair;
  }
}

template <int L>
dgd::Pose<double, L> PoseFrom(const PoseNumbers& pose) {
  return {pose.rotation.topLeftCorner<L, L>(), pose.translation.head<L>()};
}

template <int L>
Eigen::Vector3d CenterOf(const AnySet<double, L>& set) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  center.head<L>() = std::visit([](const auto& of) { return dgd::Vector<double, L>(of.core.Center()); }, set);
  return center;
}

template <int L>
RealTwist RandomTwist(Random& random, double extent) {
  RealTwist twist;
  twist.linear = (extent * RandomUnitVector(random, L)).cast<Real>();
  twist.angular = (L == 3 ? random.UnitVector() : Eigen::Vector3d((random.Flip() ? 1 : -1) * Eigen::Vector3d::UnitZ()))
                      .cast<Real>();
  return twist;
}

template <int L>
double RateOf(const dgd::PoseGradient<double, L>& gradient, const RealTwist& twist) {
  const Eigen::Vector3d linear = twist.linear.cast<double>(), angular = twist.angular.cast<double>();
  return gradient.Rate(linear.head<L>(), angular.tail<(L == 3 ? 3 : 1)>());
}

/// What one pair's gradient is found to be.
struct Comparison {
  bool is_unique;
  double error;  ///< Of the rate, as a part of the gradient's length.
  double jump;   ///< Difference of the rates forwards and backwards, likewise.
  double uncertainty;
};

/// The gradient and the normal that it belongs to.
template <int L>
struct Solution {
  dgd::Gradient<double, L> gradient;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// Solved twice: from the last normal on, the second query takes second-order steps where the first one cut.
template <int L>
Solution<L> Solve(const PairNumbers& numbers, Kind kind, const AnySet<double, L>& set_1,
                  const AnySet<double, L>& set_2) {
  constexpr dgd::Settings<double> kSettings{.relative_tolerance = 1e-15};
  const dgd::Pose<double, L> pose_1 = PoseFrom<L>(numbers.pose_1), pose_2 = PoseFrom<L>(numbers.pose_2);
  const AnyPair<double, L> pair(set_1, pose_1, set_2, pose_2);
  dgd::WarmStart<double, L> warm_start;
  (void)pair.GrowthDistance(kSettings, &warm_start);
  const dgd::Result<double, L> growth = pair.GrowthDistance(kSettings, &warm_start);
  Solution<L> solution;
  if constexpr (L == 3) {
    if (kind == Kind::kSignedDistance) {
      const dgd::SignedDistanceResult<double> distance = pair.SignedDistance(growth, &warm_start, kSettings);
      solution.normal = distance.normal;
      solution.gradient = std::visit(
          [&](const auto& a, const auto& b) { return dgd::SignedDistanceGradient(a, pose_1, b, pose_2, distance); },
          set_1, set_2);
      return solution;
    }
  }
  solution.normal.template head<L>() = growth.normal;
  solution.gradient = std::visit(
      [&](const auto& a, const auto& b) { return dgd::GrowthDistanceGradient(a, pose_1, b, pose_2, growth); }, set_1,
      set_2);
  return solution;
}

/// Along one random twist of both sets.
template <int L>
Comparison Compare(Random& random, const PairNumbers& numbers, Kind kind) {
  const AnySet<double, L> set_1 = MakeSet<double, L>(numbers.set_1), set_2 = MakeSet<double, L>(numbers.set_2);
  const auto [gradient, normal] = Solve<L>(numbers, kind, set_1, set_2);
  const double extent = AnyPair<double, L>(numbers).Extent();
  const RealTwist twist_1 = RandomTwist<L>(random, extent), twist_2 = RandomTwist<L>(random, extent);
  const double length = (gradient.pose_1.linear.norm() + gradient.pose_2.linear.norm()) * extent +
                        gradient.pose_1.angular.norm() + gradient.pose_2.angular.norm();

  const ExtendedSet at_1(numbers.set_1, CenterOf<L>(set_1), numbers.pose_1);
  const ExtendedSet at_2(numbers.set_2, CenterOf<L>(set_2), numbers.pose_2);
  const auto distance = [&, normal = normal](Real time) {
    const ExtendedSet moved_1 = at_1.Moved(twist_1, time), moved_2 = at_2.Moved(twist_2, time);
    return kind == Kind::kSignedDistance ? ExtendedSignedDistance(moved_1, moved_2, normal)
                                         : ExtendedGrowthDistance(moved_1, moved_2, L, normal);
  };
  // So small that few pairs have a kink or a strong curve within the step, relative to the way between the centres:
  // 1e-19 over this is still 1e-11.
  const Real step = 2e-8L * std::min(Real(1), (at_2.Center() - at_1.Center()).norm() / Real(extent));
  const DifferenceQuotient quotient = DifferenceQuotientOf(distance, step);
  const Real here = distance(0), forwards = distance(step) - here, backwards = here - distance(-step);
  const double rate = RateOf<L>(gradient.pose_1, twist_1) + RateOf<L>(gradient.pose_2, twist_2);
  return {gradient.IsUnique(), std::abs(double(quotient.rate - Real(rate))) / length,
          std::abs(double((forwards - backwards) / step)) / length, double(quotient.uncertainty) / length};
}

/// Largest error relative to the gradient's length.
constexpr double kError = 1e-7, kPlainError = 1e-5;
/// Above, the quotient is none of a smooth function: a kink, or a curve as sharp as one, is within the step.
constexpr double kSmoothJump = 1e-5, kSmoothUncertainty = 1e-8;

template <int L>
void CheckRandomPairs(int count, Kind kind) {
  Random random(TestSeed());
  int unique = 0, unmeasurable = 0, inexact = 0, smooth_but_not_unique = 0;
  double largest = 0, largest_plain = 0;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    PairNumbers numbers = RandomPairIn<L>(random);
    Place(random, Placement::kGeneric, numbers);
    const Comparison comparison = Compare<L>(random, numbers, kind);
    const bool is_smooth = comparison.jump <= kSmoothJump && comparison.uncertainty <= kSmoothUncertainty;
    unique += comparison.is_unique;
    if (!comparison.is_unique) {
      smooth_but_not_unique += is_smooth;
      continue;
    }
    if (!is_smooth) {
      ++unmeasurable;
      continue;
    }
    const bool is_plain = IsPlain(numbers.set_1.type) || IsPlain(numbers.set_2.type);
    double& largest_of = is_plain ? largest_plain : largest;
    largest_of = std::max(largest_of, comparison.error);
    inexact += !is_plain && comparison.error > kError;
    EXPECT_LE(comparison.error, kPlainError) << "pair " << i << "\n" << Dump(numbers);
  }
  std::printf(
      "%d pairs, %d unique (%d not measurable), largest error %.1e (%d above %.0e), without features %.1e; "
      "%d not reported as unique without a kink\n",
      count, unique, unmeasurable, largest, inexact, kError, largest_plain, smooth_but_not_unique);
  EXPECT_LE(inexact, 1 + 1e-4 * count);
  EXPECT_LE(unmeasurable, 2 + 2e-3 * count);
  if (kind == Kind::kGrowthDistance) {
    EXPECT_GE(unique, 0.95 * count);
    EXPECT_LE(smooth_but_not_unique, 2 + 1e-3 * count);
  } else {
    EXPECT_GE(unique, 0.3 * count) << "of those that are apart";
  }
}

TEST(Gradient, RandomPairs_AreTheDifferenceQuotientsInSpace) {
  CheckRandomPairs<3>(TestCount(20000, 500), Kind::kGrowthDistance);
}
TEST(Gradient, RandomPairs_AreTheDifferenceQuotientsInThePlane) {
  CheckRandomPairs<2>(TestCount(10000, 500), Kind::kGrowthDistance);
}
TEST(SignedDistanceGradient, RandomPairs_AreTheDifferenceQuotients) {
  CheckRandomPairs<3>(TestCount(5000, 200), Kind::kSignedDistance);
}

}  // namespace
}  // namespace dgd_test
