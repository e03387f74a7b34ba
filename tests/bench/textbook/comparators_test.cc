// The algorithms that the paper compares with, each answer judged by its certificate, which proves it by the sets
// alone, and by the solver's bounds: a comparison is fair only with what solves the same problem as well.
#include "bench/textbook/comparators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "dgd/solver/tolerances.h"
#include "support/random.h"

namespace dgd_bench {
namespace {

using dgd_test::Random;
using dgd_test::SetNumbers;
using dgd_test::SetType;

constexpr double kTolerance = dgd::kSqrtEpsilon<double>;

const PairClass& ClassOf(const std::string& name) {
  for (const PairClass& each : AllPairClasses()) {
    if (each.name == name) return each;
  }
  throw std::invalid_argument("no class " + name);
}

/// Overlaps and gaps are both frequent: nearer than the benchmarks' own poses.
PairPoses DrawNearPoses(Random& random, const GrowthPair& pair) { return DrawPoses(random, 3, 0.25 * pair.Extent()); }

/// One algorithm on one class of pairs, and what its answers must fulfil.
struct Demand {
  const char* name;
  GrowthAlgorithm algorithm;
  const char* pair_class;
  double gap;               ///< Certified.
  double primal;            ///< Infeasibility, as a part of the pair's extent.
  double least_solved = 1;  ///< Share of the queries that end optimal.
  double most_warm = 0;     ///< Mean iterations of a warm query, and at most half of a cold one's; 0 for no warm ones.
};

void PrintTo(const Demand& demand, std::ostream* stream) { *stream << demand.name; }

/// Whether an answer that calls itself optimal is one.
void ExpectCertified(const GrowthPair& pair, const GrowthAnswer& answer, const Demand& demand) {
  // Where the centres nearly coincide, roundoff is much of the growth distance; twice in a thousand times it is small.
  const double slack = demand.gap + demand.primal + 1e-12 / std::min(1.0, answer.upper_bound);
  ASSERT_LE(answer.sample.relative_gap, slack);
  ASSERT_LE(answer.sample.primal_infeasibility, demand.primal * pair.Extent() * std::max(1.0, answer.upper_bound));
  ASSERT_LE(answer.sample.dual_infeasibility, 1e-9);
  const GrowthAnswer ours = pair.Solve({});
  ASSERT_LE(answer.lower_bound, ours.upper_bound * (1 + slack));
  ASSERT_LE(ours.lower_bound, answer.upper_bound * (1 + slack));
  ASSERT_GE(answer.sample.iterations, 1);
}

class Comparators : public testing::TestWithParam<Demand> {};
INSTANTIATE_TEST_SUITE_P(
    All, Comparators,
    testing::Values(Demand{"IeCurved", GrowthAlgorithm::kInternalExpanding, "curved", 2e-8, 1e-9},
                    Demand{"IeRoundedHulls", GrowthAlgorithm::kInternalExpanding, "rounded-hulls", 2e-8, 1e-9},
                    Demand{"IeSharpHulls", GrowthAlgorithm::kInternalExpanding, "sharp-hulls", 2e-8, 1e-9},
                    Demand{"IeDsf", GrowthAlgorithm::kInternalExpanding, "dsf", 2e-8, 1e-9},
                    Demand{"IncSharpHulls", GrowthAlgorithm::kIncremental, "sharp-hulls", 1e-11, 1e-12, 1, 2},
                    Demand{"IncMeshes", GrowthAlgorithm::kIncremental, "meshes", 1e-11, 1e-12, 1, 4},
                    Demand{"DcfDsf", GrowthAlgorithm::kContactFeatures, "dsf", 2e-8, 1e-9, 0.998},
                    Demand{"DcolCurved", GrowthAlgorithm::kConic, "curved", 2 * kTolerance, 1e-9, 0.998},
                    Demand{"DcolRoundedHulls", GrowthAlgorithm::kConic, "rounded-hulls", 2 * kTolerance, 1e-9, 0.998},
                    Demand{"DcolSharpHulls", GrowthAlgorithm::kConic, "sharp-hulls", 2 * kTolerance, 1e-9, 0.998}),
    [](const auto& test) { return test.param.name; });

TEST_P(Comparators, RandomPairs_AreCertifiedAndEndSoonerToALooserTolerance) {
  const Demand& demand = GetParam();
  const PairClass& pair_class = ClassOf(demand.pair_class);
  Random random(dgd_test::TestSeed());
  const Meshes meshes = EllipsoidMeshes(random);
  const int pairs = dgd_test::TestCount(400) / pair_class.poses_factor, poses = 5 * pair_class.poses_factor;
  int solved = 0, overlaps = 0;
  constexpr double kLoose = 1e-3;
  double cold_iterations = 0, loose_iterations = 0, warm_iterations = 0;
  for (int i = 0; i < pairs && !HasFatalFailure(); ++i) {
    const dgd_test::PairNumbers sets = pair_class.draw_sets(random, meshes);
    const std::unique_ptr<GrowthPair> pair = MakeComparedPair(sets.set_1, sets.set_2);
    for (int j = 0; j < poses && !HasFatalFailure(); ++j) {
      pair->MoveTo(DrawNearPoses(random, *pair));
      const GrowthAnswer cold = pair->Solve({.algorithm = demand.algorithm});
      solved += !cold.sample.is_failure;
      if (!cold.sample.is_failure) ExpectCertified(*pair, cold, demand);
      overlaps += cold.upper_bound <= 1;
      cold_iterations += cold.sample.iterations;
      if (demand.algorithm != GrowthAlgorithm::kIncremental) {
        const GrowthAnswer loose = pair->Solve({.algorithm = demand.algorithm, .tolerance = kLoose});
        ASSERT_LE(loose.sample.relative_gap, loose.sample.is_failure ? 1 : 2 * kLoose);
        loose_iterations += loose.sample.iterations;
      }
      if (demand.most_warm == 0) continue;
      const GrowthAnswer warm = pair->Solve({.algorithm = demand.algorithm, .is_warm = true});
      ExpectCertified(*pair, warm, demand);
      warm_iterations += warm.sample.iterations;
    }
  }
  const int count = pairs * poses;
  EXPECT_GE(solved, demand.least_solved * count);
  EXPECT_GE(8 * overlaps, count);
  EXPECT_LE(8 * overlaps, 7 * count);
  EXPECT_LE(warm_iterations, demand.most_warm * count);
  EXPECT_LE(2 * warm_iterations, cold_iterations);
  EXPECT_LT(loose_iterations, cold_iterations);
}

// What Newton's steps are for.
TEST(ContactFeatures, SmoothPairs_TakeHalfTheEvaluationsOfCuttingPlanes) {
  Random random(dgd_test::TestSeed());
  double evaluations = 0, cutting_planes = 0;
  for (int i = 0; i < 100; ++i) {
    const dgd_test::PairNumbers sets = ClassOf("dsf").draw_sets(random, {});
    const std::unique_ptr<GrowthPair> pair = MakeComparedPair(sets.set_1, sets.set_2);
    pair->MoveTo(DrawNearPoses(random, *pair));
    evaluations += pair->Solve({.algorithm = GrowthAlgorithm::kContactFeatures}).sample.iterations;
    cutting_planes += pair->Solve({.algorithm = GrowthAlgorithm::kPlain}).sample.iterations;
  }
  EXPECT_LE(evaluations, cutting_planes / 2);
}

constexpr Demand kExact{"", GrowthAlgorithm::kIncremental, "", 1e-11, 1e-12};
constexpr GrowthQuery kIncremental{.algorithm = GrowthAlgorithm::kIncremental};

// Every vertex and nearly every edge is at the border of what the ray sees of the set. Once, an edge of the far side
// was followed from there, and the search ended at a crossing below the top.
TEST(Incremental, Tetrahedra_FarSideIsNotFollowed) {
  Random random(dgd_test::TestSeed());
  const auto draw = [&] {
    SetNumbers set{.type = SetType::kPolytope};
    for (int i = 0; i < 4; ++i) set.points.push_back(random.InCube());
    return set;
  };
  for (int i = 0; i < dgd_test::TestCount(10000) && !HasFatalFailure(); ++i) {
    const SetNumbers set_1 = draw();
    const std::unique_ptr<GrowthPair> pair = MakeComparedPair(set_1, draw());
    if (!pair->Takes(kIncremental)) continue;  // As good as flat.
    pair->MoveTo(DrawNearPoses(random, *pair));
    // Thin ones magnify roundoff.
    ExpectCertified(*pair, pair->Solve(kIncremental), {"", GrowthAlgorithm::kIncremental, "", 1e-8, 1e-9});
  }
}

// Faces of four sides, parallel and upright ones, edges along the ray, vertices over vertices: the overlay is
// degenerate in every way.
TEST(Incremental, AlignedBoxes_AreCertified) {
  SetNumbers cube{.type = SetType::kBox, .lengths = Eigen::Vector3d::Ones()};
  const std::unique_ptr<GrowthPair> pair = MakeComparedPair(cube, cube);
  PairPoses poses;
  for (int i = 0; i < 7 * 7 * 7; ++i) {
    poses.last_pose_2 = poses.pose_2;
    poses.pose_2.translation = {double(i % 7 - 3), double(i / 7 % 7 - 3), double(i / 49 - 3)};
    if (poses.pose_2.translation.isZero()) continue;
    if (poses.last_pose_2.translation.isZero()) poses.last_pose_2.translation.x() = 1;
    pair->MoveTo(poses);
    for (const bool is_warm : {false, true}) {
      const GrowthAnswer answer = pair->Solve({.algorithm = GrowthAlgorithm::kIncremental, .is_warm = is_warm});
      ExpectCertified(*pair, answer, kExact);
      // Each face of set 1 is at 1 and scales so: the largest coordinate decides.
      ASSERT_NEAR(answer.upper_bound, 0.5 * poses.pose_2.translation.lpNorm<Eigen::Infinity>(), 1e-12);
    }
  }
}

TEST(ComparedPair, SetsThatAnAlgorithmDoesNotTake_AreRefused) {
  Random random(1);
  const SetNumbers box{.type = SetType::kBox, .lengths = {1, 2, 3}}, ball{.type = SetType::kPoint, .radius = 1};
  const SetNumbers cone{.type = SetType::kCone, .lengths = {1, 1, 0}};
  const SetNumbers dsf = ClassOf("dsf").draw_sets(random, {}).set_1;
  SetNumbers many{.type = SetType::kPolytope};
  for (int i = 0; i < 700; ++i) many.points.push_back(random.UnitVector());  // More than 1024 facets.
  const auto takes = [](const SetNumbers& set_1, const SetNumbers& set_2, GrowthAlgorithm algorithm) {
    return MakeComparedPair(set_1, set_2)->Takes({.algorithm = algorithm});
  };
  EXPECT_TRUE(takes(box, box, GrowthAlgorithm::kIncremental));
  EXPECT_FALSE(takes(box, ball, GrowthAlgorithm::kIncremental));
  EXPECT_TRUE(takes(dsf, dsf, GrowthAlgorithm::kContactFeatures));
  EXPECT_FALSE(takes(dsf, cone, GrowthAlgorithm::kContactFeatures));
  EXPECT_TRUE(takes(box, cone, GrowthAlgorithm::kConic));
  EXPECT_FALSE(takes(box, dsf, GrowthAlgorithm::kConic));
  EXPECT_FALSE(takes(box, many, GrowthAlgorithm::kConic));
  const SetNumbers circle{.type = SetType::kCircle, .radius = 1};
  EXPECT_FALSE(takes(circle, circle, GrowthAlgorithm::kInternalExpanding));
}

}  // namespace
}  // namespace dgd_bench
