// The conic comparator against the solver's certificate, and its parts against what they say of themselves.
#include "bench/textbook/conic.h"

#include <gtest/gtest.h>

#include <array>

#include "bench/textbook/random_textbook_pair.h"

namespace dgd_bench {
namespace {

using dgd_test::PairNumbers;
using dgd_test::Placement;
using dgd_test::Random;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;
using Eigen::Vector4d;

using AnyPair = dgd_test::AnyPair<double, 3>;

constexpr std::array kConicTypes = {SetType::kPoint, SetType::kSegment, SetType::kBox,       SetType::kCylinder,
                                    SetType::kCone,  SetType::kFrustum, SetType::kEllipsoid, SetType::kPolytope};
constexpr double kTolerance = dgd::kSqrtEpsilon<double>;

std::optional<ConicSet> ConicSetFrom(const SetNumbers& set) {
  return dgd_test::WithCore<double, 3>(set, [&set](const auto& core) -> std::optional<ConicSet> {
    if constexpr (ConicCore<std::remove_cvref_t<decltype(core)>>) return ConicSetOf(core, set.radius);
    return std::nullopt;
  });
}

dgd::Result<double> Solve(const PairNumbers& pair, double tolerance = kTolerance) {
  const std::optional<ConicSet> set_1 = ConicSetFrom(pair.set_1), set_2 = ConicSetFrom(pair.set_2);
  if (!set_1 || !set_2) return {};
  return ConicGrowthDistance(*set_1, PoseFrom(pair.pose_1), *set_2, PoseFrom(pair.pose_2), tolerance);
}

PairNumbers RandomPair(Random& random, SetType type_1, SetType type_2, bool is_rounded) {
  const auto draw = [&](SetType type) {
    return RandomSetOf(random, type, kTwoDecades, is_rounded || !dgd_test::InfoOf(type).is_solid);
  };
  PairNumbers pair;
  pair.set_1 = draw(type_1);
  pair.set_2 = draw(type_2);
  return pair;
}

PairNumbers Balls(double radius_1, double radius_2, const Vector3d& way) {
  PairNumbers pair;
  pair.set_1.type = pair.set_2.type = SetType::kPoint;
  pair.set_1.radius = radius_1;
  pair.set_2.radius = radius_2;
  pair.pose_2.translation = way;
  return pair;
}

// All optimal answers are certified. One in ten thousand stalls, mostly of sets a hundred times longer than thick:
// the matrix of the last steps is too close to singular for the multipliers.
TEST(Conic, RandomPairs_AreSolvedAndCertified) {
  Random random(dgd_test::TestSeed());
  // The gap twice the tolerance: its own measure of the dual residual's share is of first order.
  constexpr Demands kDemands{.gap = 2 * kTolerance, .primal = 1e-9, .separation = 2 * kTolerance};
  SolvedShare all;
  for (std::size_t i = 0; i < kConicTypes.size(); ++i) {
    for (std::size_t j = i; j < kConicTypes.size(); ++j) {
      const SolvedShare share = SolvePlacedPairs(
          random, dgd_test::TestCount(20),
          [&] { return RandomPair(random, kConicTypes[i], kConicTypes[j], random.Flip()); },
          [](const PairNumbers& pair) { return Solve(pair); }, kDemands);
      std::printf("%s, %s: %d of %d solved\n", InfoOf(kConicTypes[i]).name, InfoOf(kConicTypes[j]).name, share.solved,
                  share.pairs);
      EXPECT_GE(share.Share(), 0.97);
      all += share;
    }
  }
  EXPECT_GE(all.Share(), 0.998);
}

TEST(Conic, Balls_HaveRatioOfDistanceToRadii) {
  const dgd::Result<double> result = Solve(Balls(0.5, 1, Vector3d(0, 0, 6)));
  ASSERT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_NEAR(result.upper_bound, 4, 4 * kTolerance);
  EXPECT_NEAR(result.lower_bound, 4, 4 * kTolerance);
  EXPECT_NEAR(result.separation, 4.5, 6 * kTolerance);
  EXPECT_TRUE(result.normal.isApprox(Vector3d::UnitZ(), 1e-6)) << result.normal.transpose();
  EXPECT_TRUE(result.witness_1.isApprox(Vector3d(0, 0, 0.5), 1e-6)) << result.witness_1.transpose();
  EXPECT_TRUE(result.witness_2.isApprox(Vector3d(0, 0, 5), 1e-6)) << result.witness_2.transpose();
}

TEST(Conic, LooserTolerance_EndsSoonerAndIsKept) {
  Random random(dgd_test::TestSeed());
  constexpr double kLoose = 1e-3;
  int sooner = 0, looser = 0;
  constexpr int kPairs = 100;
  for (int i = 0; i < kPairs; ++i) {
    PairNumbers pair = RandomPair(random, SetType::kCylinder, SetType::kCone, false);
    Place(random, Placement::kGeneric, pair);
    const dgd::Result<double> loose = Solve(pair, kLoose), tight = Solve(pair);
    const double gap = AnyPair(pair).Certify(loose).relative_gap;
    EXPECT_EQ(loose.status, dgd::Status::kOptimal);
    EXPECT_LE(gap, 2 * kLoose);
    sooner += loose.iterations < tight.iterations;
    looser += gap > 1e-6;
  }
  EXPECT_GE(sooner, 0.9 * kPairs);
  EXPECT_GE(looser, 0.5 * kPairs);
}

/// A point from the set's frame, where the constraints hold it at scale 1: the least of their slacks.
double LeastSlack(const ConicSet& set, const Vector3d& point) {
  Vector4d offset;
  offset << point - set.center, 1;
  double least = std::numeric_limits<double>::infinity();
  if (set.faces.rows() > 0) least = (set.faces * offset).minCoeff();
  if (set.has_cone) {
    const Vector4d slack = set.cone * offset;
    least = std::min(least, slack[0] - slack.tail<3>().norm());
  }
  return least;
}

TEST(ConicSet, Constraints_HoldOfThePointsOfTheCore) {
  Random random(dgd_test::TestSeed());
  for (const SetType type : kConicTypes) {
    if (!dgd_test::InfoOf(type).is_solid) continue;
    int inside = 0;
    constexpr int kPoints = 1000;
    for (int i = 0; i < kPoints; ++i) {
      const SetNumbers numbers = RandomSetOf(random, type, {0.5, 2}, false);
      const std::optional<ConicSet> set = ConicSetFrom(numbers);
      ASSERT_TRUE(set.has_value());
      const Vector3d point = 1.2 * random.InCube();
      const double distance =
          dgd_test::WithCore<double, 3>(numbers, [&](const auto& core) { return double(core.Distance(point)); });
      const double slack = LeastSlack(*set, point);
      inside += distance == 0;
      if (std::abs(slack) > 1e-9) {
        EXPECT_EQ(slack > 0, distance == 0) << dgd_test::InfoOf(type).name << ' ' << slack << ' ' << distance;
      }
    }
    EXPECT_GE(inside, 0.05 * kPoints) << dgd_test::InfoOf(type).name;
    EXPECT_LE(inside, 0.95 * kPoints) << dgd_test::InfoOf(type).name;
  }
}

TEST(ConicSet, MovedCenter_IsWhereItIsScaledAbout) {
  dgd::Box<double> box(Vector3d(1, 2, 0.5));
  dgd::Segment<double> segment(1);
  dgd::Cylinder<double> cylinder(2, 0.5);
  for (const Vector3d& near : {Vector3d(0.3, 1, 0.2), Vector3d(0, -3, -0.9)}) {
    box.MoveCenterNear(near);
    segment.MoveCenterNear(near);
    cylinder.MoveCenterNear(near);
    const auto check = [](const auto& core, double radius) {
      const dgd::RoundedSet set{core, radius};
      const dgd::RoundedSet<dgd::Point<double>> ball{{}, 0.1};
      const dgd::Pose<double> pose{dgd::Matrix3<double>::Identity(), Vector3d(1, 2, 3)};
      const dgd::Result<double> result =
          ConicGrowthDistance(*ConicSetOf(core, radius), {}, *ConicSetOf(ball.core, ball.radius), pose);
      const dgd::Certificate certificate = dgd::Certify(set, {}, ball, pose, result);
      EXPECT_TRUE(certificate.Holds(1e-7, 2 * kTolerance))
          << certificate.primal_infeasibility << ' ' << certificate.relative_gap;
    };
    check(box, 0);
    check(segment, 0.2);
    check(cylinder, 0);
    check(cylinder, 0.2);
  }
}

TEST(ConicSet, WhatHasNoConicForm_IsRefused) {
  static_assert(!ConicCore<dgd::Dsf<double>>);
  static_assert(!ConicCore<dgd::Triangle<double>>);
  static_assert(ConicCore<dgd::Mesh<double>>);
  EXPECT_FALSE(ConicSetOf(dgd::Point<double>(), 0));
  EXPECT_FALSE(ConicSetOf(dgd::Segment<double>(1), 0));
  dgd::Segment<double> about_its_end(1);
  about_its_end.MoveCenterNear(Vector3d(0, 0, 1));
  EXPECT_FALSE(ConicSetOf(about_its_end, 0.1));
  EXPECT_FALSE(ConicSetOf(dgd::Box<double>(Vector3d(1, 0, 1)), 0.1));
  EXPECT_FALSE(ConicSetOf(dgd::Ellipsoid<double>(Vector3d(1, 0, 1)), 0.1));
  EXPECT_FALSE(ConicSetOf(dgd::Cone<double>(1, 0), 0));
  EXPECT_TRUE(ConicSetOf(dgd::Segment<double>(0), 0.1));

  Random random(1);
  std::vector<Vector3d> points;
  for (int i = 0; i < kMostConicFaces / 2; ++i) points.push_back(random.UnitVector());
  EXPECT_TRUE(ConicSetOf(dgd::BuildConvexHull(points), 0));
  for (int i = 0; i < 100; ++i) points.push_back(random.UnitVector());
  EXPECT_FALSE(ConicSetOf(dgd::BuildConvexHull(points), 0));
}

}  // namespace
}  // namespace dgd_bench
