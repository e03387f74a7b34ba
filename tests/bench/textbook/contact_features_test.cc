// The Newton comparator against the solver's certificate and the cutting plane alone.
#include "bench/textbook/contact_features.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "bench/textbook/plain_algorithm.h"
#include "bench/textbook/random_textbook_pair.h"

namespace dgd_bench {
namespace {

using dgd_test::PairNumbers;
using dgd_test::Placement;
using dgd_test::Random;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

using AnyPair = dgd_test::AnyPair<double, 3>;
using MadeSet = std::unique_ptr<DifferentiableSupportFunction>;

constexpr double kTolerance = dgd::kSqrtEpsilon<double>;

/// Null where there is no second derivative.
MadeSet SetFrom(const SetNumbers& set) {
  return dgd_test::WithCore<double, 3>(set, [&set](const auto& core) -> MadeSet {
    using Core = std::remove_cvref_t<decltype(core)>;
    if constexpr (DifferentiableCore<Core>) {
      return std::make_unique<DifferentiableSupportFunctionOf<Core>>(dgd::RoundedSet<Core>{core, set.radius});
    }
    return nullptr;
  });
}

PairNumbers RandomPair(Random& random, SetType type_1, SetType type_2) {
  PairNumbers pair;
  pair.set_1 = RandomSetOf(random, type_1, kTwoDecades, random.Flip());
  pair.set_2 = RandomSetOf(random, type_2, kTwoDecades, random.Flip());
  return pair;
}

dgd::Result<double> Solve(const PairNumbers& pair, double tolerance = kTolerance) {
  return ContactFeatureGrowthDistance(*SetFrom(pair.set_1), PoseFrom(pair.pose_1), *SetFrom(pair.set_2),
                                      PoseFrom(pair.pose_2), tolerance);
}

int CuttingPlanesOf(const PairNumbers& pair) {
  return PlainGrowthDistance<3>(*SetFrom(pair.set_1), PoseFrom(pair.pose_1), *SetFrom(pair.set_2),
                                PoseFrom(pair.pose_2))
      .iterations;
}

TEST(ContactFeatures, RandomPairs_AreSolvedAndCertified) {
  Random random(dgd_test::TestSeed());
  constexpr std::array kTypes = {SetType::kDsf, SetType::kEllipsoid};
  for (const SetType type_1 : kTypes) {
    for (const SetType type_2 : kTypes) {
      const SolvedShare share = SolvePlacedPairs(
          random, dgd_test::TestCount(50), [&] { return RandomPair(random, type_1, type_2); },
          [](const PairNumbers& pair) { return Solve(pair); }, {.gap = 1.01 * kTolerance, .primal = 1e-9});
      std::printf("%s, %s: %d of %d solved\n", InfoOf(type_1).name, InfoOf(type_2).name, share.solved, share.pairs);
      EXPECT_GE(share.Share(), 0.998);
    }
  }
}

// What Newton's steps are for.
TEST(ContactFeatures, SmoothPairs_TakeHalfTheEvaluationsOfCuttingPlanes) {
  Random random(dgd_test::TestSeed());
  int evaluations = 0, cutting_planes = 0;
  for (int i = 0; i < 200; ++i) {
    PairNumbers pair = RandomPair(random, SetType::kDsf, i % 2 == 0 ? SetType::kDsf : SetType::kEllipsoid);
    Place(random, Placement::kGeneric, pair);
    evaluations += Solve(pair).iterations;
    cutting_planes += CuttingPlanesOf(pair);
  }
  EXPECT_LE(evaluations, cutting_planes / 2);
}

TEST(ContactFeatures, Balls_HaveRatioOfDistanceToRadii) {
  PairNumbers pair;
  pair.set_1.type = pair.set_2.type = SetType::kEllipsoid;
  pair.set_1.lengths = Vector3d::Constant(0.3);
  pair.set_1.radius = 0.2;
  pair.set_2.lengths = Vector3d::Constant(1);
  pair.pose_2.translation = Vector3d(0, 6, 0);
  const dgd::Result<double> result = Solve(pair);
  ASSERT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_NEAR(result.upper_bound, 4, 4 * kTolerance);
  EXPECT_NEAR(result.lower_bound, 4, 4 * kTolerance);
  EXPECT_NEAR(result.separation, 4.5, 6 * kTolerance);
  EXPECT_TRUE(result.normal.isApprox(Vector3d::UnitY(), 1e-6)) << result.normal.transpose();
  EXPECT_TRUE(result.witness_1.isApprox(Vector3d(0, 0.5, 0), 1e-6)) << result.witness_1.transpose();
  EXPECT_TRUE(result.witness_2.isApprox(Vector3d(0, 5, 0), 1e-6)) << result.witness_2.transpose();
}

TEST(ContactFeatures, LooserTolerance_EndsSoonerAndIsKept) {
  Random random(dgd_test::TestSeed());
  constexpr double kLoose = 1e-3;
  int sooner = 0, looser = 0;
  constexpr int kPairs = 100;
  for (int i = 0; i < kPairs; ++i) {
    PairNumbers pair = RandomPair(random, SetType::kDsf, SetType::kDsf);
    Place(random, Placement::kGeneric, pair);
    const dgd::Result<double> loose = Solve(pair, kLoose), tight = Solve(pair);
    const double gap = AnyPair(pair).Certify(loose).relative_gap;
    EXPECT_EQ(loose.status, dgd::Status::kOptimal);
    EXPECT_LE(gap, 1.01 * kLoose);
    sooner += loose.iterations < tight.iterations;
    looser += gap > 1e-7;
  }
  EXPECT_GE(sooner, 0.9 * kPairs);
  EXPECT_GE(looser, 0.5 * kPairs);
}

TEST(ContactFeatures, CurvedSupport_IsTheDerivativeOfSupport) {
  Random random(dgd_test::TestSeed());
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 100; ++i) {
    SetNumbers numbers;
    numbers.type = SetType::kEllipsoid;
    numbers.lengths = Vector3d(1, 0.5, 2);
    numbers.radius = i % 2 == 0 ? 0.3 : 0;
    const MadeSet set = SetFrom(numbers);
    const Vector3d direction = random.Uniform(0.5, 3) * random.UnitVector();
    const dgd::CurvedPoint<double> curved = set->CurvedSupport(direction);
    EXPECT_TRUE(curved.point.isApprox(set->Support(direction), 1e-12));
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = kStep * Vector3d::Unit(axis);
      const Vector3d difference = set->Support(direction + step) - set->Support(direction - step);
      EXPECT_LE((difference / (2 * kStep) - curved.derivative.col(axis)).norm(), 1e-6);
    }
  }
}

TEST(ContactFeatures, CoresOfSeveralPieces_AreRefused) {
  static_assert(DifferentiableCore<dgd::Dsf<double>>);
  static_assert(DifferentiableCore<dgd::CoreReference<dgd::Ellipsoid<double>>>);
  static_assert(!DifferentiableCore<dgd::Cylinder<double>>);
  static_assert(!DifferentiableCore<dgd::Frustum<double>>);
  static_assert(!DifferentiableCore<dgd::Box<double>>);
  SetNumbers cone;
  cone.type = SetType::kCone;
  cone.lengths = Vector3d::Ones();
  EXPECT_EQ(SetFrom(cone), nullptr);
}

}  // namespace
}  // namespace dgd_bench
