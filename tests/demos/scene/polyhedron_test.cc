// Contract of ConvexHull: faces outward and counter-clockwise, every edge between two faces at an angle, Euler's
// formula; inner points and points on faces are no vertices. Centroid and distances against closed forms.
#include "scene/polyhedron.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "scene/random_polytope.h"
#include "scene/shape.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

void ExpectClosedAndConvex(const Polyhedron& hull) {
  for (const Polyhedron::Face& face : hull.faces) {
    const Vector3d& a = hull.vertices[face.vertices[0]];
    const Vector3d across = (hull.vertices[face.vertices[1]] - a).cross(hull.vertices[face.vertices[2]] - a);
    EXPECT_GT(across.dot(face.normal), 0) << "clockwise";
    EXPECT_NEAR(face.normal.norm(), 1, 1e-12);
    for (const Vector3d& vertex : hull.vertices) EXPECT_LT(face.normal.dot(vertex - a), 1e-12) << "not convex";
  }
  // A closed surface of triangles has three half edges a face.
  EXPECT_EQ(hull.vertices.size() + hull.faces.size(), hull.faces.size() * 3 / 2 + 2);
}

TEST(PolyhedronTest, Box_HasTwelveEdgesWithoutDiagonals) {
  const Polyhedron box = CoreOf(Box{Vector3d(1, 2, 3)}, 0);
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_EQ(box.faces.size(), 12u);
  EXPECT_EQ(box.edges.size(), 12u);
  ExpectClosedAndConvex(box);
}

TEST(PolyhedronTest, RandomPolytopes_AreClosedAndConvex) {
  Random random(3, 0);
  for (int i = 0; i < 50; ++i) ExpectClosedAndConvex(RandomPolytope(random, random.Integer(4, 30), 1));
}

TEST(PolyhedronTest, InnerPoint_IsNoVertex) {
  const Polyhedron hull = ConvexHull({{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0.2}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(hull.vertices, (std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

TEST(PolyhedronTest, TooFewOrCoplanarPoints_Throw) {
  EXPECT_THROW(ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}), std::invalid_argument);
}

TEST(PolyhedronTest, Tetrahedron_CentroidIsTheMeanOfItsVertices) {
  const Polyhedron hull = ConvexHull({{0, 0, 0}, {4, 0, 0}, {0, 8, 0}, {0, 0, 12}});
  EXPECT_LT((Centroid(hull) - Vector3d(1, 2, 3)).norm(), 1e-14);
}

TEST(PolyhedronTest, Box_CentroidIsUnmovedByWhereTheDiagonalsRun) {
  const Vector3d offset(3, -2, 5);
  std::vector<Vector3d> corners = CoreOf(Box{Vector3d(1, 2, 3)}, 0).vertices;
  for (Vector3d& corner : corners) corner += offset;
  EXPECT_LT((Centroid(ConvexHull(corners)) - offset).norm(), 1e-14);
}

TEST(PolyhedronTest, Box_DistanceToBoundaryIsTheLeastHalfExtent) {
  const Polyhedron box = CoreOf(Box{Vector3d(1, 2, 3)}, 0);
  EXPECT_NEAR(DistanceToBoundary(box, Vector3d::Zero()), 1, 1e-14);
  EXPECT_NEAR(DistanceToBoundary(box, Vector3d(0, 2.5, 0)), -0.5, 1e-14);
}

}  // namespace
}  // namespace dgd_demos
