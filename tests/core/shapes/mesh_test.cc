#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "dgd/shapes/box.h"
#include "dgd/shapes/polytope.h"
#include "dgd/solver/tolerances.h"
#include "support/random_sets.h"
#include "support/sets/transformed.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

template <class S>
void CheckMesh(const Points& points, double discretisation = 0) {
  CheckShape(dgd::Mesh<S>(points), {.type = CoreType::kMesh, .points = points}, discretisation);
}

TEST(Mesh, Contract_HoldsForRandomHulls) {
  Random random(TestSeed());
  for (int i = 0; i < 10; ++i) {
    const ReferenceSet set = RandomSet(random, CoreType::kPolytope, false);
    SCOPED_TRACE(i);
    CheckMesh<double>(set.points);
    CheckMesh<float>(set.points);
  }
}

TEST(Mesh, Contract_HoldsForFlatHulls) {
  CheckMesh<double>({{1, 2, 3}});
  CheckMesh<double>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  CheckMesh<double>({{0, 0, 0}, {1, 1, 1}, {0.25, 0.25, 0.25}});
  CheckMesh<double>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}});
  CheckMesh<float>({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
}

/// No point of the set is higher than the support point, with and without a hint, but for rounding.
template <class S>
void CheckHeights(const Points& points, Random& random) {
  const dgd::Mesh<S> mesh(points);
  double reach = 0;
  for (const Vector3d& point : points) reach = std::max(reach, point.norm());
  // The facets' normals, and just beside them, are where the heights of a merged facet differ by rounding.
  std::vector<Vector3d> directions = mesh.Hull().normals;
  for (const Vector3d& normal : mesh.Hull().normals) {
    directions.push_back(normal + random.LogUniform(1e-17, 1e-3) * random.UnitVector());
  }
  if (directions.size() > 400) directions.resize(400);
  for (int i = 0; i < 100; ++i) directions.push_back(random.UnitVector());
  for (const Vector3d& direction : directions) {
    const double highest = mesh.SupportValue(direction.cast<S>());
    const auto hint = static_cast<dgd::VertexId>(random.Below(static_cast<int>(mesh.VertexCount())));
    for (const auto& support : {mesh.Support(direction.cast<S>()), mesh.Support(direction.cast<S>(), hint)}) {
      EXPECT_NEAR(direction.dot(support.point.template cast<double>()), highest, 8 * double(dgd::kEpsilon<S>) * reach)
          << direction.transpose();
    }
  }
}

Points Turned(Points points, Random& random) {
  const Eigen::Matrix3d rotation = random.Rotation();
  for (Vector3d& point : points) point = rotation * point;
  return points;
}

// Merged facets of many vertices, whose turned coordinates are not exactly in a plane.
TEST(Mesh, Support_IsHighestOnMergedFacets) {
  Random random(TestSeed());
  Points prism, grid;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * std::numbers::pi * i / 200;
    for (const double z : {-1.0, 1.0}) prism.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  for (int z = 0; z < 6; ++z) {
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 6; ++x) grid.emplace_back(x / 5.0, y / 5.0, z / 5.0);
    }
  }
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    CheckHeights<double>(Turned(prism, random), random);
    CheckHeights<float>(Turned(prism, random), random);
    CheckHeights<double>(Turned(grid, random), random);
    CheckHeights<float>(Turned(grid, random), random);
  }
}

TEST(Mesh, Support_IsHighestOnManyVerticesAndNearDuplicates) {
  Random random(TestSeed());
  Points ball;
  for (int i = 0; i < 1500; ++i) ball.push_back(random.UnitVector());
  CheckHeights<double>(ball, random);
  CheckHeights<float>(ball, random);
  Points doubled(ball.begin(), ball.begin() + 200);
  for (int i = 0; i < 200; ++i) doubled.push_back(doubled[std::size_t(i)] + 1e-15 * random.UnitVector());
  CheckHeights<double>(doubled, random);
  CheckHeights<float>(doubled, random);
}

// Short edges, whose ends differ in height by less than rounding, must not end the walk; nor must the rounding of
// coordinates far from the origin.
TEST(Mesh, Support_IsHighestOverShortEdges) {
  Random random(TestSeed());
  for (const double distance : {1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2}) {
    SCOPED_TRACE(distance);
    Points points;
    for (int i = 0; i < 100; ++i) {
      points.push_back(random.UnitVector());
      points.push_back(points.back() + distance * random.UnitVector());
      points.push_back(points.back() + distance * random.UnitVector());
    }
    CheckHeights<double>(points, random);
    CheckHeights<float>(points, random);
    for (Vector3d& point : points) point = 1e-3 * point + Vector3d(300, 200, 100);
    CheckHeights<double>(points, random);
  }
}

// Nearly flat, below what makes a hull solid: the vertices stick out of the plane, and the highest is not always where
// a walk along the border ends.
TEST(Mesh, Support_IsHighestOnNearlyFlatHulls) {
  Random random(TestSeed());
  for (int i = 0; i < 50; ++i) {
    Points points;
    for (int j = 0; j < 200; ++j) {
      const double angle = 2 * std::numbers::pi * j / 200;
      points.emplace_back(std::cos(angle), std::sin(angle), random.Uniform(-3e-13, 3e-13));
    }
    const dgd::Mesh<double> mesh(points);
    ASSERT_EQ(mesh.Hull().dimension, 2);
    const Vector3d up(0, 0, 1);
    for (dgd::VertexId hint = 0; hint < mesh.VertexCount(); hint += 10) {
      EXPECT_EQ(mesh.Support(up, hint).point.z(), mesh.SupportValue(up));
    }
  }
}

// Through what stands between a core and a query, too.
TEST(Mesh, GuessSupport_IsAVertexAboutAsHighAsAny) {
  Random random(TestSeed());
  std::vector<Vector3d> points;
  for (int i = 0; i < 500; ++i) points.push_back(random.UnitVector());
  const dgd::Mesh<double> mesh(points);
  const dgd::CoreReference<dgd::Mesh<double>> reference(mesh);
  const Transformed<dgd::CoreReference<dgd::Mesh<double>>> moved(reference, 2 * Eigen::Matrix3d::Identity(),
                                                                 Vector3d(1, 2, 3));
  EXPECT_TRUE(dgd::IsGuessing(mesh) && dgd::IsGuessing(reference) && dgd::IsGuessing(moved));
  EXPECT_FALSE(dgd::IsGuessing(dgd::Polytope<double>(std::vector<Vector3d>(points.begin(), points.begin() + 20))));
  EXPECT_FALSE(dgd::IsGuessing(dgd::Box<double>({1, 1, 1})));
  for (int i = 0; i < TestCount(1000); ++i) {
    const Vector3d direction = random.UnitVector();
    const dgd::SupportPoint<double> guess = dgd::GuessSupport(reference, direction);
    ASSERT_LT(guess.feature, mesh.VertexCount());
    EXPECT_EQ(guess.point, mesh.Vertex(guess.feature));
    EXPECT_GE(guess.point.dot(direction), 0.97 * mesh.SupportValue(direction));
    EXPECT_EQ(dgd::GuessSupport(moved, direction).point, 2 * guess.point + Vector3d(1, 2, 3));
  }
}

// What a plane that turns about an edge meets first is the facet beside. Through what stands between a core and a
// query, too.
TEST(Mesh, SteepestAscent_LeadsToTheFacetBeside) {
  Random random(TestSeed());
  Points points;
  for (int i = 0; i < 300; ++i) points.push_back(Vector3d(1, 0.5, 0.2).cwiseProduct(random.UnitVector()));
  const dgd::Mesh<double> mesh(points);
  const dgd::CoreReference<dgd::Mesh<double>> reference(mesh);
  const Eigen::Matrix3d stretch = Vector3d(1, 2, 3).asDiagonal();
  const Transformed<dgd::CoreReference<dgd::Mesh<double>>> moved(reference, stretch, Vector3d(1, 2, 3));
  EXPECT_TRUE(mesh.IsLinked() && reference.IsLinked() && moved.IsLinked());
  EXPECT_FALSE(dgd::Polytope<double>(Points(points.begin(), points.begin() + 20)).IsLinked());
  const dgd::ConvexHull& hull = mesh.Hull();
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    const std::span<const dgd::VertexId> corners(hull.facet_vertices.data() + hull.facet_start[facet],
                                                 hull.facet_vertices.data() + hull.facet_start[facet + 1]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dgd::VertexId from = corners[i], to = corners[(i + 1) % corners.size()];
      const Vector3d begin = mesh.Vertex(from), side = mesh.Vertex(to) - begin, up = hull.normals[facet];
      Vector3d outwards = side.cross(up);
      if (outwards.dot(mesh.Vertex(corners[(i + 2) % corners.size()]) - begin) > 0) outwards = -outwards;

      const dgd::EdgeSlope<double> ascent = reference.SteepestAscent(from, up, outwards);
      ASSERT_LT(ascent.vertex, mesh.VertexCount());
      EXPECT_LT(ascent.slope, 1e-9);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), ascent.vertex), 0);
      Vector3d beside = side.cross(mesh.Vertex(ascent.vertex) - begin).normalized();
      if (beside.dot(begin) < 0) beside = -beside;
      EXPECT_NEAR(mesh.SupportValue(beside), beside.dot(begin), 1e-13);

      const Eigen::Matrix3d back = stretch.inverse();
      EXPECT_EQ(moved.SteepestAscent(from, back * up, back * outwards).vertex, ascent.vertex);
    }
  }
  EXPECT_EQ(mesh.SteepestAscent(0, Vector3d::UnitZ(), Vector3d::Zero()).slope,
            -std::numeric_limits<double>::infinity());
}

TEST(Mesh, SupportFace_KeepsTheSupportPointOfALargeFacet) {
  Points prism;
  constexpr int kSides = 40;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    for (const double z : {-1.0, 1.0}) prism.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  CheckMesh<double>(prism, 1e-15);
}

TEST(Mesh, Constructor_RejectsEmptyAndNonFinitePoints) {
  ExpectRejected([] { return dgd::Mesh<double>(Points{}); }, "at least one point");
  const Points bad = {{0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}};
  ExpectRejected([&] { return dgd::Mesh<double>(bad); }, "hull point 1 must be finite; got (1");
}

}  // namespace
}  // namespace dgd_test
