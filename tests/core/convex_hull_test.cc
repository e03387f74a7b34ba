#include "dgd/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::BuildConvexHull;
using dgd::ConvexHull;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Points Moved(Points points, const Eigen::Matrix3d& rotation, const Vector3d& translation, double scale = 1) {
  for (Vector3d& point : points) point = scale * (rotation * point) + translation;
  return points;
}

Points Cube() {
  Points points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) points.emplace_back(x, y, z);
    }
  }
  return points;
}

Points InBall(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(random.Uniform(0.3, 1) * random.UnitVector());
  return points;
}

double Extent(const Points& points) {
  double extent = 0;
  for (const Vector3d& point : points) extent = std::max(extent, (point - points[0]).norm());
  return extent;
}

int FacetCount(const ConvexHull& hull) { return static_cast<int>(hull.normals.size()); }

int FacetSize(const ConvexHull& hull, int facet) {
  const auto f = static_cast<std::size_t>(facet);
  return hull.facet_start[f + 1] - hull.facet_start[f];
}

std::vector<dgd::VertexId> Loop(const ConvexHull& hull, int facet) {
  const auto begin = hull.facet_vertices.begin() + hull.facet_start[static_cast<std::size_t>(facet)];
  return {begin, begin + FacetSize(hull, facet)};
}

/// The vertices are points of the set, each once.
void CheckVertices(const ConvexHull& hull, const Points& points) {
  for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
    EXPECT_NE(std::find(points.begin(), points.end(), hull.vertices[i]), points.end()) << "vertex " << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(hull.vertices[i], hull.vertices[j]) << i << " " << j;
  }
}

/// Every edge lies between exactly two facets, which pass it in opposite directions; and Euler's formula.
void CheckEdges(const ConvexHull& hull) {
  std::map<std::pair<dgd::VertexId, dgd::VertexId>, int> edges;
  for (int facet = 0; facet < FacetCount(hull); ++facet) {
    const std::vector<dgd::VertexId> loop = Loop(hull, facet);
    ASSERT_GE(loop.size(), 3U);
    for (std::size_t i = 0; i < loop.size(); ++i) ++edges[{loop[i], loop[(i + 1) % loop.size()]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1) << edge.first << "-" << edge.second;
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << edge.first << "-" << edge.second;
  }
  EXPECT_EQ(hull.vertices.size() + hull.normals.size(), edges.size() / 2 + 2);
}

/// Vertex -> facets is the inverse of facet -> vertices.
void CheckAdjacency(const ConvexHull& hull) {
  ASSERT_EQ(hull.facet_start.size(), hull.normals.size() + 1);
  ASSERT_EQ(hull.vertex_start.size(), hull.vertices.size() + 1);
  ASSERT_EQ(hull.vertex_facets.size(), hull.facet_vertices.size());
  std::set<std::pair<std::size_t, int>> from_vertices, from_facets;
  for (std::size_t vertex = 0; vertex < hull.vertices.size(); ++vertex) {
    EXPECT_GT(hull.vertex_start[vertex + 1], hull.vertex_start[vertex]) << "vertex " << vertex << " has no facet";
    for (int i = hull.vertex_start[vertex]; i < hull.vertex_start[vertex + 1]; ++i) {
      from_vertices.emplace(vertex, hull.vertex_facets[static_cast<std::size_t>(i)]);
    }
  }
  for (int facet = 0; facet < FacetCount(hull); ++facet) {
    for (const dgd::VertexId vertex : Loop(hull, facet)) from_facets.emplace(vertex, facet);
  }
  EXPECT_EQ(from_vertices, from_facets);
}

/// Unit normals; no point of the set above a facet, and the facet's vertices on it; counterclockwise from outside.
void CheckFacets(const ConvexHull& hull, const Points& points, double tolerance) {
  for (int facet = 0; facet < FacetCount(hull); ++facet) {
    const Vector3d& normal = hull.normals[static_cast<std::size_t>(facet)];
    EXPECT_NEAR(normal.norm(), 1, 1e-14);
    const std::vector<dgd::VertexId> loop = Loop(hull, facet);
    const Vector3d& first = hull.vertices[loop[0]];
    for (const Vector3d& point : points) EXPECT_LE(normal.dot(point - first), tolerance) << "facet " << facet;
    Vector3d newell = Vector3d::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector3d& here = hull.vertices[loop[i]];
      EXPECT_NEAR(normal.dot(here - first), 0, tolerance) << "facet " << facet;
      newell += (here - first).cross(hull.vertices[loop[(i + 1) % loop.size()]] - first);
    }
    EXPECT_GE(newell.dot(normal), 0) << "facet " << facet << " runs clockwise";
  }
}

/// The centre is inside and the ball about it too, by the support heights of the points themselves.
void CheckBall(const ConvexHull& hull, const Points& points, double tolerance) {
  ASSERT_TRUE(hull.center.allFinite());
  ASSERT_GE(hull.inradius, 0);
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Vector3d direction = i < FacetCount(hull) ? hull.normals[static_cast<std::size_t>(i)] : random.UnitVector();
    double height = -std::numeric_limits<double>::infinity();
    for (const Vector3d& point : points) height = std::max(height, direction.dot(point - hull.center));
    EXPECT_GE(height, hull.inradius - tolerance);
  }
}

/// No point of the set is farther along any direction than the farthest vertex: none of the vertices is missing.
void CheckSupport(const ConvexHull& hull, const Points& points, double tolerance) {
  Random random(4);
  const auto height = [](const Points& set, const Vector3d& direction) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vector3d& point : set) highest = std::max(highest, direction.dot(point));
    return highest;
  };
  for (int i = 0; i < 100; ++i) {
    const Vector3d direction = i < 6 ? Vector3d(Vector3d::Unit(i / 2) * (i % 2 == 0 ? 1 : -1)) : random.UnitVector();
    EXPECT_LE(height(points, direction) - height(hull.vertices, direction), tolerance) << direction.transpose();
  }
}

/// All of the above for a solid hull. Qhull may move a facet by some roundings of the extent.
ConvexHull CheckSolid(const Points& points) {
  const ConvexHull hull = BuildConvexHull(points);
  EXPECT_EQ(hull.dimension, 3);
  double reach = 0;
  for (const Vector3d& point : points) reach = std::max(reach, point.lpNorm<Eigen::Infinity>());
  const double rounding = 1e-15 * reach;
  CheckVertices(hull, points);
  CheckEdges(hull);
  CheckAdjacency(hull);
  CheckFacets(hull, points, 1e-13 * Extent(points) + rounding);
  CheckBall(hull, points, rounding);
  CheckSupport(hull, points, 1e-13 * Extent(points) + rounding);
  return hull;
}

TEST(ConvexHull, CubeWithExtraPoints_HasEightVerticesAndSixSquares) {
  Points points = Cube();
  Random random(TestSeed());
  for (int i = 0; i < 30; ++i) points.push_back(random.InCube());                     // Inside.
  for (int i = 0; i < 8; ++i) points.push_back(points[static_cast<std::size_t>(i)]);  // Again.
  for (int i = 0; i < 12; ++i) {                                                      // On the faces and edges.
    Vector3d on_face = random.InCube();
    on_face[i % 3] = i < 6 ? 1 : -1;
    points.push_back(on_face);
    on_face[(i + 1) % 3] = 1;
    points.push_back(on_face);
  }
  std::reverse(points.begin(), points.end());
  const ConvexHull hull = CheckSolid(points);
  EXPECT_EQ(hull.vertices.size(), 8U);
  ASSERT_EQ(FacetCount(hull), 6);
  for (int facet = 0; facet < 6; ++facet) EXPECT_EQ(FacetSize(hull, facet), 4);
  EXPECT_NEAR(hull.center.norm(), 0, 1e-15);
  EXPECT_LE(hull.inradius, 1);
  EXPECT_NEAR(hull.inradius, 1, 1e-13);
}

TEST(ConvexHull, TurnedCubes_KeepSixFacets) {
  Random random(TestSeed());
  for (int i = 0; i < 200; ++i) {
    const Points points = Moved(Cube(), random.Rotation(), 3 * random.InCube());
    const ConvexHull hull = CheckSolid(points);
    EXPECT_EQ(hull.vertices.size(), 8U);
    EXPECT_EQ(FacetCount(hull), 6);
  }
}

TEST(ConvexHull, RandomPoints_FulfilAllInvariants) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(500); ++i) {
    SCOPED_TRACE(i);
    CheckSolid(InBall(random, 4 + random.Below(100)));
  }
}

TEST(ConvexHull, SizeAndPlace_DoNotMatter) {
  Random random(TestSeed());
  for (const double scale : {1e-9, 1e-6, 1.0, 1e3, 1e9}) {
    for (const double distance : {0.0, 1.0, 1e3, 1e5}) {
      SCOPED_TRACE(::testing::Message() << "scale " << scale << ", " << distance << " of it from the origin");
      const Points points = Moved(InBall(random, 40), random.Rotation(), scale * distance * random.UnitVector(), scale);
      const ConvexHull hull = CheckSolid(points);
      EXPECT_GT(hull.inradius, 0.1 * scale);
    }
  }
}

TEST(ConvexHull, Needles_FulfilAllInvariants) {
  Random random(TestSeed());
  for (const double width : {1e-2, 1e-4, 1e-6, 1e-8}) {
    for (int i = 0; i < 50; ++i) {
      SCOPED_TRACE(::testing::Message() << "width " << width << " case " << i);
      Points needle = InBall(random, 20), sheet = InBall(random, 20);
      for (Vector3d& point : needle) point.head<2>() *= width;
      for (Vector3d& point : sheet) point.z() *= width;
      CheckSolid(Moved(needle, random.Rotation(), random.InCube()));
      CheckSolid(Moved(sheet, random.Rotation(), random.InCube()));
    }
  }
}

/// Thickness to extent, from well solid down to rounding; flat ones are flat, and in between either answer is right.
void CheckNearlyFlat(double thickness, bool turned) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(::testing::Message() << "thickness " << thickness << " turned " << turned << " case " << i);
    Points points = InBall(random, 12);
    for (Vector3d& point : points) point.z() *= thickness;
    if (turned) points = Moved(points, random.Rotation(), Vector3d::Zero());
    const ConvexHull hull = BuildConvexHull(points);
    if (thickness >= 1e-9) {
      EXPECT_EQ(hull.dimension, 3);
    }
    if (thickness <= 1e-14) {
      EXPECT_EQ(hull.dimension, 2);
    }
    ASSERT_GE(hull.dimension, 2);
    CheckVertices(hull, points);
    CheckEdges(hull);
    CheckAdjacency(hull);
    CheckFacets(hull, points, 4e-12);
    CheckBall(hull, points, 1e-15);
    CheckSupport(hull, points, 4e-12);
  }
}

TEST(ConvexHull, NearlyFlat_1e9) { CheckNearlyFlat(1e-9, false), CheckNearlyFlat(1e-9, true); }
TEST(ConvexHull, NearlyFlat_1e10) { CheckNearlyFlat(1e-10, false), CheckNearlyFlat(1e-10, true); }
TEST(ConvexHull, NearlyFlat_1e11) { CheckNearlyFlat(1e-11, false), CheckNearlyFlat(1e-11, true); }
TEST(ConvexHull, NearlyFlat_1e12) { CheckNearlyFlat(1e-12, false), CheckNearlyFlat(1e-12, true); }
TEST(ConvexHull, NearlyFlat_1e13) { CheckNearlyFlat(1e-13, false), CheckNearlyFlat(1e-13, true); }
TEST(ConvexHull, NearlyFlat_1e14) { CheckNearlyFlat(1e-14, false), CheckNearlyFlat(1e-14, true); }
TEST(ConvexHull, NearlyFlat_1e15) { CheckNearlyFlat(1e-15, false), CheckNearlyFlat(1e-15, true); }

TEST(ConvexHull, Flat_HasTwoFacetsBackToBack) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    const Points square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}};
    const bool turned = i > 0;
    const Eigen::Matrix3d rotation = turned ? random.Rotation() : Eigen::Matrix3d::Identity();
    const Points points = Moved(square, rotation, turned ? random.InCube() : Vector3d(0, 0, 5));
    const ConvexHull hull = BuildConvexHull(points);
    ASSERT_EQ(hull.dimension, 2);
    ASSERT_EQ(FacetCount(hull), 2);
    EXPECT_EQ(hull.normals[0], -hull.normals[1]);
    EXPECT_EQ(hull.inradius, 0);
    EXPECT_NEAR((hull.center - (points[0] + points[2]) / 2).norm(), 0, 1e-14);
    // A turned point on an edge may stick out of it by rounding and be a vertex.
    if (!turned) {
      EXPECT_EQ(hull.vertices.size(), 4U);
    }
    CheckVertices(hull, points);
    CheckEdges(hull);
    CheckAdjacency(hull);
    CheckFacets(hull, points, 1e-14);
  }
}

TEST(ConvexHull, CollinearPoints_MakeASegment) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    const Vector3d origin = i == 0 ? Vector3d::Zero() : random.InCube(), direction = random.UnitVector();
    Points points;
    for (const double t : {0.5, 2.0, 0.0, -1.0, 1.5, 2.0}) points.push_back(origin + t * direction);
    const ConvexHull hull = BuildConvexHull(points);
    EXPECT_EQ(hull.dimension, 1);
    ASSERT_EQ(hull.vertices.size(), 2U);
    EXPECT_EQ(std::set<double>({(hull.vertices[0] - points[1]).norm(), (hull.vertices[0] - points[3]).norm()}).count(0),
              1U);
    EXPECT_NEAR((hull.vertices[0] - hull.vertices[1]).norm(), 3, 1e-14);
    EXPECT_NEAR((hull.center - (origin + 0.5 * direction)).norm(), 0, 1e-14);
    EXPECT_EQ(hull.inradius, 0);
    EXPECT_TRUE(hull.normals.empty());
  }
}

TEST(ConvexHull, OnePointOrItsCopies_MakeAPoint) {
  for (const std::size_t count : {1U, 2U, 50U}) {
    const ConvexHull hull = BuildConvexHull(Points(count, Vector3d(1, 2, 3)));
    EXPECT_EQ(hull.dimension, 0);
    ASSERT_EQ(hull.vertices.size(), 1U);
    EXPECT_EQ(hull.vertices[0], Vector3d(1, 2, 3));
    EXPECT_EQ(hull.center, Vector3d(1, 2, 3));
    EXPECT_EQ(hull.inradius, 0);
    EXPECT_TRUE(hull.normals.empty());
  }
}

TEST(ConvexHull, Centroid_OfKnownSolids) {
  // A corner of the cube: a quarter of the way to each of the three others.
  const ConvexHull corner = CheckSolid({{0, 0, 0}, {4, 0, 0}, {0, 8, 0}, {0, 0, 12}});
  EXPECT_NEAR((corner.center - Vector3d(1, 2, 3)).norm(), 0, 1e-14);
  // A square pyramid: a quarter of the height above the base.
  const ConvexHull pyramid = CheckSolid({{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {0, 0, 4}});
  EXPECT_NEAR((pyramid.center - Vector3d(0, 0, 1)).norm(), 0, 1e-14);
  // A prism over a right triangle.
  const ConvexHull prism = CheckSolid({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 2}, {3, 0, 2}, {0, 3, 2}});
  EXPECT_NEAR((prism.center - Vector3d(1, 1, 1)).norm(), 0, 1e-14);
  EXPECT_NEAR(prism.inradius, std::sqrt(0.5), 1e-13);
  // A flat triangle, and one that hangs in space.
  const ConvexHull triangle = BuildConvexHull(Points{{0, 0, 1}, {3, 0, 1}, {0, 3, 1}});
  EXPECT_NEAR((triangle.center - Vector3d(1, 1, 1)).norm(), 0, 1e-15);
}

Points Grid(int count) {
  Points points;
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x) points.push_back(Vector3d(x, y, z) / (count - 1));
    }
  }
  return points;
}

Points Prism(int sides, double height) {
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {0.0, height}) points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  return points;
}

// Many points in few planes, turned, so that none is in its plane exactly; from micrometres to kilometres, and a
// kilometre from the origin, where a millimetre has ten digits left.
TEST(ConvexHull, CoplanarPoints_OfAnySizeAnywhere_FulfilAllInvariants) {
  Random random(TestSeed());
  const Points grid = Grid(5);
  const Points prism = Prism(100, 2), coin = Prism(100, 1e-2), foil = Prism(100, 1e-4);
  Points cone = Prism(100, 0);
  cone.emplace_back(0, 0, 1);
  Points plateau;
  for (int i = 0; i < 1000; ++i) plateau.push_back(random.InCube().cwiseProduct(Vector3d(1, 1, 0)));
  plateau.emplace_back(0.1, 0.2, -1);
  for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
    for (const double distance : {0.0, 1.0, 1e3}) {
      SCOPED_TRACE(::testing::Message() << "size " << size << ", " << distance << " m away");
      for (const Points& points : {grid, prism, coin, foil, cone, plateau}) {
        CheckSolid(Moved(points, random.Rotation(), distance * random.UnitVector(), size));
      }
    }
  }
}

// Copies that differ by rounding, and by more than it, but less than what matters.
TEST(ConvexHull, NearDuplicates_FulfilAllInvariants) {
  Random random(TestSeed());
  for (const double distance : {1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8}) {
    SCOPED_TRACE(distance);
    Points doubled = InBall(random, 50), grid = Grid(4);
    for (int i = 0; i < 50; ++i) doubled.push_back(doubled[std::size_t(i)] + distance * random.UnitVector());
    for (Vector3d& point : grid) point += distance * random.InCube();
    CheckSolid(doubled);
    CheckSolid(Moved(doubled, random.Rotation(), Vector3d(300, 200, 100), 1e-3));
    CheckSolid(Moved(grid, random.Rotation(), random.InCube()));
  }
}

// The volume of a needle is less than the rounding of the tetrahedra that add up to it.
TEST(ConvexHull, Needles_KeepTheirCentreInside) {
  Random random(TestSeed());
  for (const double width : {1e-5, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11}) {
    for (int i = 0; i < 30; ++i) {
      Points needle = InBall(random, 30);
      for (Vector3d& point : needle) point.head<2>() *= width;
      needle = Moved(needle, random.Rotation(), Vector3d::Zero());
      const ConvexHull hull = BuildConvexHull(needle);
      for (const Vector3d& normal : hull.normals) {
        double height = -std::numeric_limits<double>::infinity();
        for (const Vector3d& point : needle) height = std::max(height, normal.dot(point - hull.center));
        ASSERT_GE(height, -1e-15) << "width " << width << " case " << i;
      }
    }
  }
}

// Qhull's products overflow. A flat hull would be a wrong answer.
TEST(ConvexHull, SolidPointsWithoutHull_AreRejectedSayingWhy) {
  try {
    BuildConvexHull(Moved(Cube(), Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                          Vector3d::Zero(), 1e-130));
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("Qhull finds no hull of points that reach 3.4"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("precision error"), std::string::npos) << error.what();
  }
}

TEST(ConvexHull, BadInput_IsRejectedNamingTheIndex) {
  const auto message = [](const Points& points) -> std::string {
    try {
      BuildConvexHull(points);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message({}).find("at least one point"), std::string::npos);
  Points points = Cube();
  points[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(points).find("hull point 5 must be finite; got (1.0"), std::string::npos) << message(points);
  points[5].y() = 0;
  points[2].z() = -std::numeric_limits<double>::infinity();
  EXPECT_NE(message(points).find("hull point 2 must be finite; got (-1.0"), std::string::npos) << message(points);
}

// Found by fuzz_hull: products of lengths overflowed, and a flat hull of nine points had two vertices and two facets.
TEST(ConvexHull, PointsTooFarOff_AreRefused) {
  const std::vector<Vector3d> points = {{1e160, 0, 0}, {0, 1e160, 0}, {0, 0, 1e160}, {-1e308, 1, 0}};
  try {
    dgd::BuildConvexHull(points);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("hull point 0 must be within 1e+75 m"), std::string::npos) << error.what();
  }
  const std::vector<Vector3d> farthest = {{1e75, 0, 0}, {0, 1e75, 0}, {0, 0, 1e75}, {-1e75, -1e75, -1e75}};
  const dgd::ConvexHull hull = dgd::BuildConvexHull(farthest);
  EXPECT_EQ(hull.dimension, 3);
  EXPECT_TRUE(hull.center.allFinite());
  EXPECT_GT(hull.inradius, 1e74);
}

// Found by fuzz_hull: Qhull merged the sides of a set 1e-10 thick with its faces, and the second point was no vertex.
TEST(ConvexHull, Sheet_KeepsWhatIsAVertexSeenFromAbove) {
  const Points points = {{-6.0084, -6.02392, -7.01e-10},
                         {-6.00146484375, -6.023681640625, -7.01e-10},
                         {-6.023681640625, -6.023681640625, -7.01e-10},
                         {2.351318359375, 2.492431640625, 3.84e-11},
                         {4.009521484375, 3.9560546875, 7.96e-10}};
  const ConvexHull hull = BuildConvexHull(points);
  EXPECT_EQ(hull.vertices.size(), points.size());
  CheckEdges(hull);
  CheckFacets(hull, points, 1e-13);
  CheckSupport(hull, points, 1e-13);
}

// Areas of 1e-320 square metres are no numbers to divide by.
TEST(ConvexHull, FlatAndTiny_TheCentreIsAmongThePoints) {
  for (const double size : {1e-160, 1e-155, 1e-100}) {
    const std::vector<Vector3d> triangle = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    const dgd::ConvexHull hull = dgd::BuildConvexHull(triangle);
    ASSERT_TRUE(hull.center.allFinite()) << size;
    EXPECT_LE(hull.center.cwiseAbs().maxCoeff(), size);
  }
}

}  // namespace
}  // namespace dgd_test
