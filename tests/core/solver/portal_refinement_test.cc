// The refinement to the facet by which the ray leaves: the answer to most queries of polytopes, and RayIntersection's
// where it is not certain.
#include "dgd/solver/portal_refinement.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes/polytope.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

template <class Core>
using SetOf = dgd::RoundedSet<dgd::CoreReference<Core>>;
template <class Core>
using RefinementOf = dgd::PortalRefinement<SetOf<Core>, SetOf<Core>>;
using Hull = dgd::Polytope<double>;
using HullSet = SetOf<Hull>;

std::vector<Vector3d> OnEllipsoid(Random& random, int count, const Vector3d& radii = {0.5, 0.4, 0.3}) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(radii.cwiseProduct(random.UnitVector()));
  return points;
}

template <class Core>
struct MovingPair {
  MovingPair(Random& random, const Core& core_1, const Core& core_2, double radius = 0)
      : set_1{core_1, radius},
        set_2{core_2, radius},
        pose_1{random.Rotation(), random.InCube()},
        pose_2{random.Rotation(), pose_1.translation + random.Uniform(0.2, 2) * random.UnitVector()} {
    (void)dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, {}, &state);
  }

  /// @param step  Metres and radians.
  void Move(Random& random, double step) {
    pose_2.translation += step * random.UnitVector();
    pose_2.rotation = pose_2.rotation * Eigen::AngleAxisd(step, random.UnitVector()).toRotationMatrix();
  }

  SetOf<Core> set_1, set_2;
  dgd::Pose<double> pose_1, pose_2;
  dgd::WarmStart<double> state;
};

/// @param most_infeasible  Metres.
template <class Core>
void ExpectCertified(const MovingPair<Core>& pair, const dgd::Result<double>& result, double most_infeasible = 1e-14) {
  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  const dgd::Certificate certificate = dgd::Certify(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, result);
  EXPECT_LE(certificate.primal_infeasibility, most_infeasible);
  EXPECT_LE(certificate.dual_infeasibility, 1e-14);
  EXPECT_LE(certificate.relative_gap, 1.0001 * dgd::kSqrtEpsilon<double>);
  EXPECT_LE(certificate.separation_error, 1e-14);
}

/// The query of those who watch, which no refinement answers.
template <class Core>
dgd::Result<double> ObservedGrowthDistance(const MovingPair<Core>& pair) {
  return dgd::GrowthDistance(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, {}, nullptr,
                             [](const dgd::Iterate<double, 3>&) {});
}

/// @return the part of the queries that the refinement from the last facet answers: certified, and as the observed
/// ones.
template <class Core>
double ShareAnswered(int vertices, double radius, double step) {
  Random random(TestSeed());
  int answered = 0, asked = 0;
  for (int i = 0; i < TestCount(200, 20); ++i) {
    const Core core_1(OnEllipsoid(random, vertices)), core_2(OnEllipsoid(random, vertices));
    MovingPair<Core> pair(random, core_1, core_2, radius);
    for (int frame = 0; frame < 10; ++frame) {
      pair.Move(random, step);
      RefinementOf<Core> refinement(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2);
      dgd::Result<double> result;
      ++asked;
      if (!refinement.SolveWarm({}, pair.state, result)) {
        (void)dgd::GrowthDistance(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, {}, &pair.state);
        continue;
      }
      ++answered;
      EXPECT_EQ(result.iterations, refinement.Iterations());
      ExpectCertified(pair, result);
      EXPECT_NEAR(result.upper_bound / ObservedGrowthDistance(pair).upper_bound, 1, 2 * dgd::kSqrtEpsilon<double>);
      EXPECT_NEAR((pair.pose_1.rotation * pair.state.normal_1 - result.normal).norm(), 0, 1e-14);
    }
  }
  return double(answered) / asked;
}

TEST(PortalRefinement, HullsAfterASmallMotion_AreSolvedByIt) {
  EXPECT_GT(ShareAnswered<Hull>(14, 0, 0.005), 0.9);
  EXPECT_GT(ShareAnswered<Hull>(14, 0, 0.1), 0.55);
}

TEST(PortalRefinement, RoundedHulls_MostlyAre) {
  EXPECT_GT(ShareAnswered<Hull>(14, 0.04, 0.005), 0.85);
  // Half of them by edges.
  EXPECT_GT(ShareAnswered<Hull>(14, 0.4, 0.005), 0.5);
}

TEST(PortalRefinement, MeshesWhoseFacetsAreSmallerThanTheMotion_AreReachedBySteps) {
  EXPECT_GT(ShareAnswered<dgd::Mesh<double>>(1000, 0, 0.01), 0.99);
}

/// @param most_infeasible  Metres.
/// @return the part of the queries that the refinement from the ball about the centre answers, as above.
template <class Core>
double ShareSolvedCold(int least_vertices, int most_vertices, const Vector3d& radii, double most_infeasible,
                       double radius = 0) {
  Random random(TestSeed());
  int answered = 0;
  const int asked = TestCount(400, 100);
  for (int i = 0; i < asked; ++i) {
    const auto vertices = [&] { return least_vertices + random.Below(most_vertices - least_vertices + 1); };
    const Core core_1(OnEllipsoid(random, vertices(), radii)), core_2(OnEllipsoid(random, vertices(), radii));
    MovingPair<Core> pair(random, core_1, core_2, radius);
    RefinementOf<Core> refinement(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2);
    dgd::Result<double> result;
    pair.state = {};
    if (!refinement.SolveCold({}, &pair.state, result)) continue;
    ++answered;
    EXPECT_EQ(result.iterations, refinement.Iterations());
    ExpectCertified(pair, result, most_infeasible);
    EXPECT_NEAR(result.upper_bound / ObservedGrowthDistance(pair).upper_bound, 1, 2 * dgd::kSqrtEpsilon<double>);
    // The next query goes on from there.
    EXPECT_EQ(pair.state.size, 3);
    EXPECT_NEAR((pair.pose_1.rotation * pair.state.normal_1 - result.normal).norm(), 0, 1e-14);
    RefinementOf<Core> next(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2);
    EXPECT_TRUE(next.SolveWarm({}, pair.state, result));
    EXPECT_EQ(next.Iterations(), 1);
  }
  return double(answered) / asked;
}

TEST(PortalRefinement, HullsCold_AreSolvedByIt) {
  EXPECT_GT(ShareSolvedCold<Hull>(8, 20, {0.5, 0.4, 0.3}, 1e-14), 0.95);
  EXPECT_GT(ShareSolvedCold<dgd::Mesh<double>>(100, 1000, {0.5, 0.4, 0.3}, 1e-14), 0.95);
  EXPECT_GT(ShareSolvedCold<Hull>(8, 20, {0.5, 0.4, 0.3}, 1e-14, 0.04), 0.9);
  EXPECT_GT(ShareSolvedCold<Hull>(8, 20, {0.5, 0.4, 0.3}, 1e-14, 0.4), 0.6);
  EXPECT_GT(ShareSolvedCold<dgd::Mesh<double>>(100, 1000, {0.5, 0.4, 0.3}, 1e-14, 0.04), 0.85);
  // Needles, whose growth distances, and the witness points' last digits with them, are large.
  EXPECT_GT(ShareSolvedCold<Hull>(4, 8, {1, 0.05, 0.05}, 1e-13), 0.2);
}

class PortalOfAPair : public testing::Test {
 protected:
  bool Solve(const dgd::Settings<double>& settings = {}) {
    return RefinementOf<Hull>(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2)
        .SolveWarm(settings, pair_.state, result_);
  }
  bool SolveAnew(const dgd::Settings<double>& settings = {}) {
    return RefinementOf<Hull>(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2)
        .SolveCold(settings, &pair_.state, result_);
  }

  Random random_{TestSeed()};
  const Hull core_1_{OnEllipsoid(random_, 14)}, core_2_{OnEllipsoid(random_, 14)};
  MovingPair<Hull> pair_{random_, core_1_, core_2_};
  dgd::Result<double> result_;
};

TEST_F(PortalOfAPair, Unmoved_OneEvaluation) {
  ASSERT_EQ(pair_.state.size, 3);
  ASSERT_TRUE(Solve());
  EXPECT_EQ(result_.iterations, 1);
}

TEST_F(PortalOfAPair, ApartByMoreThanIsAsked_SaysSo) {
  pair_.pose_2.translation = pair_.pose_1.translation + Vector3d(2, 1, 0);
  (void)dgd::GrowthDistance(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2, {}, &pair_.state);
  const dgd::WarmStart<double> last = pair_.state;
  const auto expect_apart = [&] {
    EXPECT_EQ(result_.status, dgd::Status::kSeparated);
    EXPECT_GT(result_.separation, 0.1);
    EXPECT_GT(result_.lower_bound, 1);
    EXPECT_LE(dgd::Certify(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2, result_).separation_error, 1e-14);
    // The next query tries the normal alone.
    EXPECT_EQ(pair_.state.size, 0);
    EXPECT_NEAR((pair_.pose_1.rotation * pair_.state.normal_1 - result_.normal).norm(), 0, 1e-14);
  };
  ASSERT_TRUE(Solve({.separation_limit = 0.1}));
  expect_apart();
  pair_.state = {};
  ASSERT_TRUE(SolveAnew({.separation_limit = 0.1}));
  expect_apart();
  // Along the line of the centres, by the only evaluation.
  EXPECT_EQ(result_.iterations, 1);
  pair_.state = last;
  ASSERT_TRUE(Solve({.separation_limit = 10}));
  EXPECT_EQ(result_.status, dgd::Status::kOptimal);
  ASSERT_TRUE(SolveAnew({.separation_limit = 10}));
  EXPECT_EQ(result_.status, dgd::Status::kOptimal);
}

TEST_F(PortalOfAPair, ColdWithANegativeRadius_IsTheQuerys) {
  for (const double radius : {-0.01, std::numeric_limits<double>::quiet_NaN()}) {
    pair_.set_2.radius = radius;
    EXPECT_FALSE(SolveAnew());
  }
}

// Two rods across each other: cylinders about edges of either meet, and so do the rods, at the sum of all radii.
TEST(PortalRefinement, RoundedRodsThatCross_LeaveByAnEdge) {
  const Hull along_x(std::vector<Vector3d>{
      {-1, 0, 0.1}, {1, 0, 0.1}, {-1, 0.1, 0}, {1, 0.1, 0}, {-1, -0.1, 0}, {1, -0.1, 0}, {-1, 0, -0.1}, {1, 0, -0.1}});
  Random random(TestSeed());
  MovingPair<Hull> pair(random, along_x, along_x, 0.2);
  pair.pose_1 = {};
  pair.pose_2 = {Eigen::AngleAxisd(1, Vector3d::UnitZ()).toRotationMatrix(), {0.01, 0.02, 1.5}};
  dgd::Result<double> result;
  pair.state = {};
  ASSERT_TRUE(RefinementOf<Hull>(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2).SolveCold({}, &pair.state, result));
  EXPECT_NEAR(result.upper_bound, 1.5 / 0.6, 1e-14);
  EXPECT_NEAR(result.normal.z(), 1, 1e-15);
  ExpectCertified(pair, result);
}

TEST_F(PortalOfAPair, UnmovedAndInCollision_NoEvaluation) {
  pair_.pose_2.translation = pair_.pose_1.translation + Vector3d(0.1, 0.2, 0.1);
  (void)dgd::GrowthDistance(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2, {}, &pair_.state);
  ASSERT_EQ(pair_.state.size, 3);
  const dgd::CollisionResult<double> result =
      dgd::DetectCollision(pair_.set_1, pair_.pose_1, pair_.set_2, pair_.pose_2, {}, &pair_.state);
  EXPECT_EQ(result.status, dgd::Status::kColliding);
  EXPECT_EQ(result.iterations, 0);
}

TEST_F(PortalOfAPair, VerticesThatAreNoMore_AreNotRead) {
  pair_.state.features_1[1] = 1000;
  EXPECT_FALSE(Solve());
}

TEST_F(PortalOfAPair, TwiceTheSameCorner_IsNoFacet) {
  pair_.state.features_1[1] = pair_.state.features_1[0];
  pair_.state.features_2[1] = pair_.state.features_2[0];
  EXPECT_FALSE(Solve());
}

TEST_F(PortalOfAPair, CentersThatCoincide_AreTheQuerys) {
  const HullSet twin{core_1_};
  dgd::Result<double> result;
  RefinementOf<Hull> refinement(twin, pair_.pose_1, twin, pair_.pose_1);
  EXPECT_FALSE(refinement.SolveWarm({}, pair_.state, result));
  EXPECT_FALSE(refinement.SolveCold({}, nullptr, result));
}

TEST_F(PortalOfAPair, NotANumber_IsTheQuerys) {
  for (double* number : {&pair_.pose_2.translation.x(), &pair_.pose_1.rotation(1, 2)}) {
    const double before = std::exchange(*number, std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(Solve());
    EXPECT_FALSE(SolveAnew());
    *number = before;
  }
}

// Wherever the steps lead, the query goes on from there, within the evaluations that are left.
TEST(PortalRefinement, AfterAnyMotion_QueriesAreCertifiedWithinTheirIterations) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(300, 30); ++i) {
    // Needles and sheets, too, whose facets are thin.
    const Vector3d radii(random.LogUniform(1e-3, 1), random.LogUniform(1e-3, 1), 1);
    const Hull core_1(OnEllipsoid(random, 8 + random.Below(30), radii)), core_2(OnEllipsoid(random, 20));
    MovingPair<Hull> pair(random, core_1, core_2, random.Flip() ? 0.05 : 0);
    for (const double step : {0.003, 0.03, 0.3, 3.0}) {
      pair.Move(random, step);
      dgd::WarmStart<double> hurried = pair.state;
      const int few = dgd::PortalRefinement<HullSet, HullSet>::kMaxColdSteps + 1 + random.Below(3);
      EXPECT_LE(dgd::GrowthDistance(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, {.max_iterations = few}, &hurried)
                    .iterations,
                few);
      const dgd::Result<double> result =
          dgd::GrowthDistance(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, {}, &pair.state);
      EXPECT_EQ(result.status, dgd::Status::kOptimal);
      const dgd::Certificate certificate = dgd::Certify(pair.set_1, pair.pose_1, pair.set_2, pair.pose_2, result);
      EXPECT_LE(certificate.primal_infeasibility, 1e-12);
      EXPECT_LE(certificate.relative_gap, 1.0001 * dgd::kSqrtEpsilon<double>);
    }
  }
}

}  // namespace
}  // namespace dgd_test
