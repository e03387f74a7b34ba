// The search along second-order steps: the answer to most queries of curved sets, and one in turns with RayIntersection
// where it gives up.
#include "dgd/solver/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
using Pose = dgd::Pose<double>;

// Behind names, so that the solver is instantiated for three pairs of types and not for nine.
using SmoothSet = dgd::RoundedSet<ErasedSmoothCore<double, 3>>;
using VertexSet = dgd::RoundedSet<ErasedVertexCore<double, 3>>;

/// Over two decades.
double RandomLength(Random& random) { return random.LogUniform(0.05, 5); }
SmoothSet RandomEllipsoid(Random& random) {
  return {Erase(dgd::Ellipsoid<double>({RandomLength(random), RandomLength(random), RandomLength(random)}))};
}
VertexSet RandomBox(Random& random) {
  return {Erase(dgd::Box<double>({RandomLength(random), RandomLength(random), RandomLength(random)}))};
}
SmoothSet RandomCylinder(Random& random) {
  return {Erase(dgd::Cylinder<double>(RandomLength(random), RandomLength(random)))};
}
SmoothSet RandomCone(Random& random) { return {Erase(dgd::Cone<double>(RandomLength(random), RandomLength(random)))}; }
VertexSet RandomCapsule(Random& random) {
  return {Erase(dgd::Segment<double>(RandomLength(random))), RandomLength(random)};
}

struct Shares {
  double answered = 0;    ///< Of the queries, by the search alone.
  double iterations = 0;  ///< Of the search, per query that it answers.
};

/// Of random pairs: certified, and as cutting planes alone find them.
template <class Make1, class Make2>
Shares CheckWalk(const Make1& make_1, const Make2& make_2) {
  Random random(TestSeed());
  Shares shares;
  const int pairs = TestCount(1000, 100);
  for (int i = 0; i < pairs; ++i) {
    const auto set_1 = make_1(random);
    const auto set_2 = make_2(random);
    using Set1 = std::remove_cvref_t<decltype(set_1)>;
    using Set2 = std::remove_cvref_t<decltype(set_2)>;
    const Pose pose_1{random.Rotation(), random.InCube()};
    const Pose pose_2{random.Rotation(), pose_1.translation + random.Uniform(0.2, 5) * random.UnitVector()};
    const AnyPair<double, 3> pair(set_1, pose_1, set_2, pose_2);
    const auto result = pair.GrowthDistance();
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    const dgd::Certificate certificate = pair.Certify(result);
    EXPECT_LE(certificate.primal_infeasibility, 1e-13);
    EXPECT_LE(certificate.dual_infeasibility, 1e-14);
    EXPECT_LE(certificate.relative_gap, 1.0001 * dgd::kSqrtEpsilon<double>);
    EXPECT_LE(certificate.separation_error, 1e-13);

    const dgd::Settings<double> settings;
    const dgd::MinkowskiDifference<Set1, Set2> difference(set_1, pose_1, set_2, pose_2);
    const dgd::NoObserver observer;
    dgd::RayIntersection<Set1, Set2> cuts(difference, settings);
    (void)cuts.Solve(dgd::QueryMode::kDistance, nullptr, observer);
    EXPECT_LE(result.lower_bound, cuts.Bounds().UpperBound() * (1 + 1e-12));
    EXPECT_LE(cuts.Bounds().LowerBound(), result.upper_bound * (1 + 1e-12));
    dgd::NewtonSearch<Set1, Set2> search(difference, settings);
    if (!search.Solve(dgd::QueryMode::kDistance, difference.EllipsoidGuess(), nullptr, observer)) continue;
    EXPECT_EQ(search.Bounds().UpperBound(), result.upper_bound);
    shares.answered += 1.0 / pairs;
    shares.iterations += search.Iterations();
  }
  shares.iterations /= shares.answered * pairs;
  return shares;
}

TEST(NewtonSearch, OnePiece_IsAlwaysAnsweredByIt) {
  const Shares shares = CheckWalk(RandomEllipsoid, RandomEllipsoid);
  EXPECT_GT(shares.answered, 0.99);
  EXPECT_LT(shares.iterations, 6);
}

TEST(NewtonSearch, PiecesOfOneSet_AreMostlyAnsweredByIt) {
  for (const Shares& shares : {CheckWalk(RandomEllipsoid, RandomBox), CheckWalk(RandomEllipsoid, RandomCylinder),
                               CheckWalk(RandomCone, RandomEllipsoid), CheckWalk(RandomEllipsoid, RandomCapsule)}) {
    EXPECT_GT(shares.answered, 0.93);
    EXPECT_LT(shares.iterations, 6);
  }
}

TEST(NewtonSearch, PiecesOfBothSets_AreMostlyAnsweredByIt) {
  for (const Shares& shares : {CheckWalk(RandomCylinder, RandomCylinder), CheckWalk(RandomCylinder, RandomBox),
                               CheckWalk(RandomCone, RandomCylinder), CheckWalk(RandomCone, RandomCapsule)}) {
    EXPECT_GT(shares.answered, 0.9);
    EXPECT_LT(shares.iterations, 6);
  }
}

// Two discs that lie upon each other: the plane touches C in a disc of both radii.
TEST(NewtonSearch, StackedCylinders_MeetInTheirCaps) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(300, 30); ++i) {
    const double radius_1 = RandomLength(random), radius_2 = RandomLength(random);
    const double half_1 = RandomLength(random), half_2 = RandomLength(random), rounding = random.Flip() ? 0.1 : 0;
    const SmoothSet set_1{Erase(dgd::Cylinder<double>(radius_1, half_1)), rounding};
    const SmoothSet set_2{Erase(dgd::Cylinder<double>(radius_2, half_2)), rounding};
    const double distance = random.Uniform(0.1, 3) * (half_1 + half_2),
                 beside = 0.5 * distance * (radius_1 + radius_2) / (half_1 + half_2 + 2 * rounding);
    const Eigen::Matrix3d axes = random.Rotation();
    const Pose pose_1{axes, random.InCube()};
    const Pose pose_2{axes, pose_1.translation + axes * Vector3d(beside, 0, distance)};
    const AnyPair<double, 3> pair(set_1, pose_1, set_2, pose_2);
    const auto result = pair.GrowthDistance();
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    EXPECT_NEAR(result.GrowthDistance(), distance / (half_1 + half_2 + 2 * rounding), 1e-12 * result.GrowthDistance());
    EXPECT_LE((result.normal - axes.col(2)).norm(), 1e-12);
    EXPECT_LE(pair.Certify(result).primal_infeasibility, 1e-13);
  }
}

/// Of which the search leaves many.
struct ConePair {
  SmoothSet set_1, set_2;
  Pose pose_1, pose_2;

  explicit ConePair(Random& random)
      : set_1(RandomCone(random)),
        set_2(RandomCone(random)),
        pose_1{random.Rotation(), random.InCube()},
        pose_2{random.Rotation(), pose_1.translation + random.Uniform(0.2, 5) * random.UnitVector()} {}

  AnyPair<double, 3> Query() const { return {set_1, pose_1, set_2, pose_2}; }

  bool IsLeftBySearch() const {
    const dgd::Settings<double> settings;
    const dgd::MinkowskiDifference<SmoothSet, SmoothSet> difference(set_1, pose_1, set_2, pose_2);
    dgd::NewtonSearch<SmoothSet, SmoothSet> search(difference, settings);
    const dgd::NoObserver observer;
    return !search.Solve(dgd::QueryMode::kDistance, difference.EllipsoidGuess(), nullptr, observer).has_value();
  }
};

// 25 iterations by measurement, 34 at most, the search's own counted.
TEST(NewtonSearch, WhatItLeaves_IsSolvedByCuttingPlanes) {
  Random random(TestSeed());
  int left = 0, longest = 0;
  double iterations = 0;
  for (int i = 0; i < TestCount(4000, 400); ++i) {
    const ConePair pair(random);
    if (!pair.IsLeftBySearch()) continue;
    ++left;
    const auto result = pair.Query().GrowthDistance();
    ASSERT_EQ(result.status, dgd::Status::kOptimal);
    const dgd::Certificate certificate = pair.Query().Certify(result);
    EXPECT_LE(certificate.primal_infeasibility, 1e-13);
    EXPECT_LE(certificate.relative_gap, 1.0001 * dgd::kSqrtEpsilon<double>);
    iterations += result.iterations;
    longest = std::max(longest, result.iterations);
    // The same yes or no.
    const auto yes_no = pair.Query().DetectCollision();
    if (result.lower_bound > 1) {
      EXPECT_EQ(yes_no.status, dgd::Status::kSeparated);
    } else if (result.upper_bound < 1) {
      EXPECT_EQ(yes_no.status, dgd::Status::kColliding);
    }
  }
  std::printf("%d left, %.2f iterations, %d at most\n", left, iterations / left, longest);
  ASSERT_GT(left, 0);
  EXPECT_LT(iterations / left, 30);
  EXPECT_LT(longest, 45);
}

TEST(NewtonSearch, WhatItLeaves_IsOneQueryToObserversAndLimits) {
  Random random(TestSeed());
  for (int left = 0; left < TestCount(40, 5);) {
    const ConePair pair(random);
    if (!pair.IsLeftBySearch()) continue;
    ++left;
    int iteration = 0;
    double lower = 0, upper = std::numeric_limits<double>::infinity();
    const auto observer = [&](const dgd::Iterate<double, 3>& iterate) {
      EXPECT_EQ(iterate.iteration, ++iteration);
      // The lower one but for rounding: see LowerBound().
      EXPECT_GE(iterate.lower_bound, lower * (1 - 8 * dgd::kEpsilon<double>));
      EXPECT_LE(iterate.upper_bound, upper);
      lower = iterate.lower_bound;
      upper = iterate.upper_bound;
    };
    const auto result = pair.Query().GrowthDistance({}, nullptr, observer);
    EXPECT_EQ(result.iterations, iteration);
    EXPECT_EQ(result.lower_bound, lower);
    EXPECT_EQ(result.upper_bound, upper);
    for (int limit = 1; limit < result.iterations; ++limit) {
      const auto limited = pair.Query().GrowthDistance({.max_iterations = limit});
      EXPECT_EQ(limited.status, dgd::Status::kIterationLimit);
      EXPECT_LE(limited.iterations, limit);
      EXPECT_LE(limited.lower_bound, result.upper_bound);
      EXPECT_GE(limited.upper_bound, result.lower_bound);
    }
  }
}

/// A part of a query, as far as its bounds go.
struct Bounds {
  double lower_bound, upper_bound;
  Vector3d normal;

  double LowerBound() const { return lower_bound; }
  double UpperBound() const { return upper_bound; }
  Vector3d Normal() const { return normal; }
};

// The soak found, in float, the best lower bound dropped for a worse one, as rounding had it above the last upper one.
TEST(NewtonSearch, BoundsThatRoundingReverses_MeetInTheUpperOne) {
  const Bounds best_lower{1 + 1e-12, 2, Vector3d::UnitX()}, worse{0.5, 3, Vector3d::UnitY()};
  Bounds last{0.9, 1, Vector3d::UnitZ()};
  dgd::MergeBoundsOf(worse, last);
  EXPECT_EQ(last.lower_bound, 0.9);
  EXPECT_EQ(last.normal, Vector3d::UnitZ());
  dgd::MergeBoundsOf(best_lower, last);
  EXPECT_EQ(last.lower_bound, 1);
  EXPECT_EQ(last.upper_bound, 1);
  EXPECT_EQ(last.normal, Vector3d::UnitX());

  const Bounds best_upper{0.5, 1, Vector3d::UnitX()};
  Bounds high{1 + 1e-12, 2, Vector3d::UnitZ()};
  dgd::MergeBoundsOf(best_upper, high);
  EXPECT_EQ(high.lower_bound, 1);
  EXPECT_EQ(high.upper_bound, 1);
  EXPECT_EQ(high.normal, Vector3d::UnitZ());
}

// A kink of two or three pieces is known from the last query: two directions find that it is where it was.
TEST(NewtonSearch, LastPieces_AreTheFirstOnes) {
  Random random(TestSeed());
  double cold = 0, warm = 0;
  for (int i = 0; i < TestCount(300, 30); ++i) {
    const auto ellipsoid = RandomEllipsoid(random);
    const auto box = RandomBox(random);
    const Pose pose_1{random.Rotation(), random.InCube()};
    Pose pose_2{random.Rotation(), pose_1.translation + random.Uniform(0.2, 5) * random.UnitVector()};
    AnyPair<double, 3> pair(ellipsoid, pose_1, box, pose_2);
    dgd::WarmStart<double> state;
    cold += pair.GrowthDistance({}, &state).iterations;
    EXPECT_GE(state.size, 1);
    pose_2.translation += 1e-4 * random.UnitVector();
    pair.MoveTo(pose_1, pose_2);
    warm += pair.GrowthDistance({}, &state).iterations;
  }
  EXPECT_LT(warm, 0.55 * cold);
}

}  // namespace
}  // namespace dgd_test
