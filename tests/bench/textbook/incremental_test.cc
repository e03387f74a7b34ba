// Inc against the certificate and the solver, on the benchmarks' hulls and meshes.
#include "bench/textbook/incremental.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bench/textbook/random_textbook_pair.h"
#include "support/pairs/random_pair.h"

namespace dgd_bench {
namespace {

constexpr Demands kExact{.gap = 1e-11, .primal = 1e-12};

/// The two sets, which must be polytopes without a radius, with the state of their queries.
class PolytopePair {
 public:
  explicit PolytopePair(const dgd_test::PairNumbers& numbers)
      : pair_(numbers),
        mesh_1_(dgd::BuildConvexHull(numbers.set_1.points)),
        mesh_2_(dgd::BuildConvexHull(numbers.set_2.points)) {}

  TextbookPair& Pair() { return pair_; }
  dgd::Result<double> Ask(IncrementalState* state = nullptr, int most_steps = kMostIncrementalSteps) const {
    return IncrementalGrowthDistance(mesh_1_, pair_.Pose1(), mesh_2_, pair_.Pose2(), state, most_steps);
  }

 private:
  TextbookPair pair_;
  HalfEdgeMesh mesh_1_, mesh_2_;
};

using DrawSets = decltype(PairClass::draw_sets);

/// The steps of a small motion are fewer from the last query's features than from the centres.
void CertifyColdAndWarm(DrawSets draw_sets, int pairs, int poses_each, double most_warm_steps) {
  dgd_test::Random random(dgd_test::TestSeed());
  const Meshes meshes = EllipsoidMeshes(random);
  int overlaps = 0;
  std::int64_t cold_steps = 0, warm_steps = 0;
  for (int i = 0; i < pairs; ++i) {
    PolytopePair polytopes(draw_sets(random, meshes));
    TextbookPair& pair = polytopes.Pair();
    for (int j = 0; j < poses_each; ++j) {
      const PairPoses poses = DrawNearPoses(random, pair.Extent());
      IncrementalState state;
      pair.MoveTo(poses.pose_1, poses.last_pose_2);
      ASSERT_TRUE(pair.IsCertified(polytopes.Ask(&state), kExact));
      pair.MoveTo(poses.pose_1, poses.pose_2);
      const dgd::Result<double> cold = polytopes.Ask();
      const dgd::Result<double> warm = polytopes.Ask(&state);
      ASSERT_TRUE(pair.IsCertified(cold, kExact));
      ASSERT_TRUE(pair.IsCertified(warm, kExact));
      overlaps += warm.upper_bound <= 1;
      cold_steps += cold.iterations;
      warm_steps += warm.iterations;
    }
  }
  const int count = pairs * poses_each;
  EXPECT_TRUE(IsBalanced(overlaps, count)) << overlaps;
  EXPECT_LE(static_cast<double>(warm_steps), most_warm_steps * count);
  EXPECT_LE(2 * warm_steps, cold_steps);
}

TEST(Incremental, Hulls_AreCertifiedColdAndWarm) {
  CertifyColdAndWarm(ClassOf("sharp-hulls").draw_sets, dgd_test::TestCount(1000), 5, 2);
}
TEST(Incremental, Meshes_AreCertifiedColdAndWarm) {
  CertifyColdAndWarm(ClassOf("meshes").draw_sets, 10, dgd_test::TestCount(200), 4);
}

dgd_test::SetNumbers RandomTetrahedron(dgd_test::Random& random) {
  dgd_test::SetNumbers set;
  set.type = dgd_test::SetType::kPolytope;
  for (int i = 0; i < 4; ++i) set.points.push_back(random.InCube());
  return set;
}

// Every vertex and nearly every edge is at the border of what the ray sees of the set. Once, an edge of the far side
// was followed from there, and the walk ended at a crossing below the top.
TEST(Incremental, Tetrahedra_FarSideIsNotFollowed) {
  CertifyColdAndWarm(
      [](dgd_test::Random& random, const Meshes&) {
        dgd_test::SetNumbers set_1 = RandomTetrahedron(random);
        return dgd_test::PairNumbers{std::move(set_1), RandomTetrahedron(random), {}, {}};
      },
      dgd_test::TestCount(10000), 1, 2);
}

// One state through a whole motion, small steps and leaps: a start is only a start.
TEST(Incremental, LongMotion_EveryAnswerCertified) {
  dgd_test::Random random(dgd_test::TestSeed());
  const Meshes meshes = EllipsoidMeshes(random);
  for (const char* pair_class : {"sharp-hulls", "meshes"}) {
    PolytopePair polytopes(ClassOf(pair_class).draw_sets(random, meshes));
    TextbookPair& pair = polytopes.Pair();
    PairPoses poses = DrawNearPoses(random, pair.Extent());
    IncrementalState state;
    for (int i = 0; i < 500; ++i) {
      pair.MoveTo(poses.pose_1, poses.pose_2);
      ASSERT_TRUE(pair.IsCertified(polytopes.Ask(&state), kExact)) << i;
      if (i % 5 == 4) {
        poses = DrawNearPoses(random, pair.Extent());
      } else {
        poses.pose_2 = dgd_test::MovedALittle(random, poses.pose_2, 3, 0.01, pair.Extent());
      }
    }
  }
}

// Cut short, it says so, and its bounds hold: the primal one comes down step by step.
TEST(Incremental, FewSteps_IterationLimitWithBounds) {
  dgd_test::Random random(dgd_test::TestSeed());
  int limits = 0;
  for (int i = 0; i < 200; ++i) {
    PolytopePair polytopes(ClassOf("sharp-hulls").draw_sets(random, {}));
    TextbookPair& pair = polytopes.Pair();
    const PairPoses poses = DrawNearPoses(random, pair.Extent());
    pair.MoveTo(poses.pose_1, poses.pose_2);
    const double truth = pair.Solve().GrowthDistance();
    double last = std::numeric_limits<double>::infinity();
    for (int steps = 1; steps < 12; ++steps) {
      const dgd::Result<double> result = polytopes.Ask(nullptr, steps);
      const dgd::Certificate certificate = pair.Certify(result);
      ASSERT_LE(certificate.primal_infeasibility, 1e-12);
      ASSERT_LE(certificate.separation_error, 1e-12);
      ASSERT_LE(result.lower_bound, truth * (1 + 1e-12));
      ASSERT_GE(result.upper_bound, truth * (1 - 1e-12));
      ASSERT_LE(result.upper_bound, last * (1 + 1e-12));
      last = result.upper_bound;
      limits += result.status == dgd::Status::kIterationLimit;
    }
  }
  EXPECT_GT(limits, 500);
}

dgd_test::SetNumbers BoxPoints(double x, double y, double z) {
  dgd_test::SetNumbers set;
  set.type = dgd_test::SetType::kPolytope;
  for (const double i : {-x, x}) {
    for (const double j : {-y, y}) {
      for (const double k : {-z, z}) set.points.push_back({i, j, k});
    }
  }
  return set;
}

// Faces of four sides, parallel and upright ones, edges along the ray, vertices over vertices: the overlay is
// degenerate in every way.
TEST(Incremental, AlignedBoxes_AreCertified) {
  PolytopePair polytopes({BoxPoints(1, 1, 1), BoxPoints(1, 1, 1), {}, {}});
  TextbookPair& pair = polytopes.Pair();
  IncrementalState state;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -3; z <= 3; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        dgd_test::PoseNumbers pose_2;
        pose_2.translation = {double(x), double(y), double(z)};
        pair.MoveTo({}, pose_2);
        ASSERT_TRUE(pair.IsCertified(polytopes.Ask(), kExact)) << "cold";
        ASSERT_TRUE(pair.IsCertified(polytopes.Ask(&state), kExact)) << "warm";
        // Each face of set 1 is at 1 and scales so: the largest coordinate decides.
        const double expected = 0.5 * std::max({std::abs(x), std::abs(y), std::abs(z)});
        ASSERT_NEAR(polytopes.Ask().GrowthDistance(), expected, 1e-12);
      }
    }
  }
}

TEST(HalfEdgeMesh, Neighbors_ShareTheirEdge) {
  dgd_test::Random random(dgd_test::TestSeed());
  const Meshes meshes = EllipsoidMeshes(random);
  const HalfEdgeMesh mesh(dgd::BuildConvexHull(meshes[0]));
  int edges = 0;
  for (int f = 0; f < mesh.FacetCount(); ++f) {
    const int first = mesh.EdgeOfFacet(f);
    int edge = first;
    do {
      ++edges;
      EXPECT_EQ(mesh.Edge(edge).facet, f);
      EXPECT_EQ(mesh.Edge(mesh.Edge(edge).twin).twin, edge);
      EXPECT_NE(mesh.Neighbor(edge), f);
      for (const int facet : {f, mesh.Neighbor(edge)}) {
        EXPECT_NEAR(mesh.Polar(facet).dot(mesh.Origin(edge)), 1, 1e-12);
        EXPECT_NEAR(mesh.Polar(facet).dot(mesh.Target(edge)), 1, 1e-12);
      }
      EXPECT_EQ(mesh.Edge(mesh.NextFromVertex(edge)).origin, mesh.Edge(edge).origin);
      edge = mesh.Edge(edge).next;
    } while (edge != first);
  }
  EXPECT_EQ(mesh.VertexCount() - edges / 2 + mesh.FacetCount(), 2);  // Euler.
}

TEST(HalfEdgeMesh, FlatHull_Throws) {
  EXPECT_THROW(HalfEdgeMesh(dgd::BuildConvexHull(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})),
               std::invalid_argument);
}

}  // namespace
}  // namespace dgd_bench
