// Points without facets: the answers are those of their hull, to the last bit once it is built.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/point_facet.h"
#include "dgd/shapes/polytope.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::ConvexHull;
using dgd::HullWithoutFacets;
using Eigen::Vector3d;
using Face = dgd::SupportingFace<double>;
using Hull = dgd::Polytope<double>;
using Points = std::vector<Vector3d>;

Points OnBall(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(random.UnitVector());
  return points;
}

Points InCube(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(random.InCube());
  return points;
}

/// A block of points, most of them on faces and edges.
Points Grid(int count) {
  Points points;
  for (int i = 0; i < count * count * count; ++i) {
    points.emplace_back(i % count, i / count % count, i / (count * count));
  }
  return points;
}

Points Prism(int sides) {
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {-0.7, 0.7}) points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  return points;
}

/// As an app that keeps floats has them: corners of a face are off its plane by their rounding.
Points TurnedInFloat(Random& random, Points points) {
  const Eigen::Matrix3d rotation = random.Rotation();
  const Vector3d offset = random.InCube();
  for (Vector3d& point : points) point = (rotation * point + offset).cast<float>().cast<double>();
  return points;
}

Points Turned(Random& random, Points points) {
  const Eigen::Matrix3d rotation = random.Rotation();
  for (Vector3d& point : points) point = rotation * point;
  return points;
}

Points Twice(Points points) {
  const Points once = points;
  points.insert(points.end(), once.begin(), once.end());
  return points;
}

/// All that make sense to scan.
std::vector<Points> SmallSets() {
  Random random(TestSeed());
  std::vector<Points> sets;
  for (int i = 0; i < 20; ++i) {
    sets.push_back(OnBall(random, 4 + random.Below(61)));
    sets.push_back(InCube(random, 8 + random.Below(57)));
    sets.push_back(TurnedInFloat(random, Grid(2)));
    sets.push_back(TurnedInFloat(random, Prism(3 + random.Below(30))));
    sets.push_back(Turned(random, Prism(3 + random.Below(30))));
    sets.push_back(Turned(random, Grid(4)));
  }
  sets.insert(sets.end(), {Grid(2), Grid(3), Grid(4), Prism(6), Prism(32), Twice(Grid(2)), Twice(Grid(3))});
  // Sets that rounding makes no facets of are built at once.
  std::erase_if(sets, [](const Points& points) { return !HullWithoutFacets(points); });
  EXPECT_GT(sets.size(), 100U);
  return sets;
}

Face SupportFace(const Hull& hull, const Vector3d& direction) {
  Face face;
  hull.SupportFace(direction, face);
  return face;
}

bool Holds(const Face& face, const Vector3d& point) {
  return std::find(face.points.begin(), face.points.begin() + face.size, point) != face.points.begin() + face.size;
}

/// Random ones, and those that bodies at rest have: along a facet's normal, but for rounding.
std::vector<Vector3d> Directions(Random& random, const ConvexHull& hull) {
  std::vector<Vector3d> directions = hull.normals;
  for (int i = 0; i < 50; ++i) directions.push_back(random.UnitVector());
  for (const Vector3d& normal : hull.normals) directions.push_back(3 * normal + 1e-9 * random.UnitVector());
  return directions;
}

/// As near to one facet's normal as to another's, where both are around the support point.
std::vector<Vector3d> DirectionsBetweenFacets(const ConvexHull& hull) {
  std::vector<Vector3d> directions;
  for (std::size_t i = 1; i < hull.normals.size(); ++i) {
    const Vector3d between = hull.normals[i] + hull.normals[i - 1];
    if (between.norm() > 0.1) directions.push_back(between);
  }
  return directions;
}

TEST(HullWithoutFacets, AnswersAreThoseOfItsHullToTheLastBit) {
  Random random(TestSeed());
  for (const Points& points : SmallSets()) {
    const ConvexHull hull = *HullWithoutFacets(points);
    const ConvexHull built = dgd::WithFacets(hull);
    const Hull first(hull), later(built);
    ASSERT_FALSE(HasFacets(first.Hull()));
    ASSERT_TRUE(HasFacets(later.Hull()));
    EXPECT_EQ(later.Center(), first.Center());
    EXPECT_EQ(later.Inradius(), first.Inradius());
    EXPECT_EQ(later.Spread(), first.Spread());
    std::vector<Vector3d> directions = Directions(random, built);
    const std::vector<Vector3d> between = DirectionsBetweenFacets(built);
    directions.insert(directions.end(), between.begin(), between.end());
    for (const Vector3d& direction : directions) {
      EXPECT_EQ(later.Support(direction).feature, first.Support(direction).feature);
      const Face face = SupportFace(first, direction), expected = SupportFace(later, direction);
      ASSERT_EQ(face.size, expected.size) << points.size() << " points, along " << direction.transpose();
      for (std::size_t i = 0; i < static_cast<std::size_t>(face.size); ++i) {
        EXPECT_EQ(face.points[i], expected.points[i]) << points.size() << " points, along " << direction.transpose();
      }
    }
  }
}

TEST(HullWithoutFacets, BallAboutTheCentre_IsInside) {
  for (const Points& points : SmallSets()) {
    const ConvexHull hull = *HullWithoutFacets(points), built = dgd::BuildConvexHull(points);
    for (std::size_t facet = 0; facet < built.normals.size(); ++facet) {
      const Vector3d& corner = built.vertices[built.facet_vertices[std::size_t(built.facet_start[facet])]];
      EXPECT_GE(built.normals[facet].dot(corner - hull.center), hull.inradius);
    }
  }
  EXPECT_GT(HullWithoutFacets(Grid(2))->inradius, 0.5 / std::sqrt(3) - 1e-5) << "of a ball of 0.5";
}

// A face is a facet of the hull as Qhull has it: nothing is above it, and it has the support point.
TEST(HullWithoutFacets, SupportFace_IsAFacetAtTheSupportPoint) {
  Random random(TestSeed());
  std::vector<Points> sets = SmallSets();
  for (const int count : {65, 100, 1000}) sets.push_back(OnBall(random, count));
  sets.push_back(Prism(200));
  sets.push_back(Grid(6));
  // Where points are off edges by float's roundoff, the facets of Qhull's that are as thin are left out.
  const std::size_t first_rough = sets.size();
  for (int i = 0; i < 20; ++i) sets.push_back(TurnedInFloat(random, Grid(3)));
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Points& points = sets[set];
    const Hull hull(*HullWithoutFacets(points)), built{points};
    for (const Vector3d& direction : Directions(random, built.Hull())) {
      const Face face = SupportFace(hull, direction);
      ASSERT_GE(face.size, 3) << points.size() << " points, along " << direction.transpose();
      ASSERT_LE(face.size, Face::kMaxPoints);
      const Vector3d normal = face.Area().normalized();
      double above = 0;
      for (const Vector3d& point : points) above = std::max(above, normal.dot(point - face.points[0]));
      EXPECT_LE(above, 1e-7) << points.size() << " points, along " << direction.transpose();
      double highest = -std::numeric_limits<double>::infinity();
      for (int i = 0; i < face.size; ++i) highest = std::max(highest, direction.dot(face.points[std::size_t(i)]));
      EXPECT_NEAR(highest, hull.SupportValue(direction), 1e-9 * direction.norm());
      if (set >= first_rough) continue;
      const Face expected = SupportFace(built, direction);
      EXPECT_NEAR(normal.dot(direction), expected.Area().normalized().dot(direction), 1e-6 * direction.norm());
    }
  }
}

// A contact patch needs all of the face at once.
TEST(HullWithoutFacets, SupportFace_HasAllCorners) {
  Random random(TestSeed());
  for (int i = 0; i < 20; ++i) {
    const Hull cube(*HullWithoutFacets(i == 0 ? Grid(3) : Turned(random, Grid(3))));
    const Vector3d up = cube.Vertex(18) - cube.Vertex(0);
    const Face face = SupportFace(cube, up + 1e-3 * random.UnitVector());
    for (const dgd::VertexId corner : {18U, 20U, 24U, 26U}) EXPECT_TRUE(Holds(face, cube.Vertex(corner))) << i;
    EXPECT_NEAR(face.Area().norm() / 2, 4, 1e-12);
  }
}

TEST(HullWithoutFacets, DirectionThatIsNone_HasTheSupportPointAlone) {
  const Hull cube(*HullWithoutFacets(Grid(2)));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3d& direction : {Vector3d(0, 0, 0), Vector3d(kNan, 0, 0), Vector3d(kNan, kNan, kNan)}) {
    EXPECT_EQ(SupportFace(cube, direction).size, 1);
  }
}

TEST(HullWithoutFacets, Distance_IsThatOfTheHull) {
  const Points cube = Grid(2);
  EXPECT_NEAR(Hull(*HullWithoutFacets(cube)).Distance({2, 0.5, 0.5}), 1, 1e-15);
  EXPECT_EQ(Hull(*HullWithoutFacets(cube)).Distance({0.7, 0.5, 0.5}), 0);
}

TEST(HullWithoutFacets, Float_HasFacetsAtOnce) {
  EXPECT_TRUE(HasFacets(dgd::Polytope<float>(*HullWithoutFacets(Grid(2))).Hull()));
}

// What is thin, tiny or wrong is said by BuildConvexHull().
TEST(HullWithoutFacets, WhatIsNotClearlySolid_IsNone) {
  Random random(TestSeed());
  const auto is_none = [](const Points& points) { return !HullWithoutFacets(points); };
  EXPECT_TRUE(is_none({}));
  EXPECT_TRUE(is_none({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(is_none(Points(10, Vector3d(1, 2, 3))));
  for (const double thickness : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4}) {
    for (int i = 0; i < 20; ++i) {
      Points sheet = InCube(random, 20), needle = InCube(random, 20);
      for (Vector3d& point : sheet) point.z() *= thickness;
      for (Vector3d& point : needle) point.head<2>() *= thickness;
      EXPECT_TRUE(is_none(Turned(random, sheet))) << thickness;
      EXPECT_TRUE(is_none(Turned(random, needle))) << thickness;
    }
  }
  for (const double size : {1e-31, 1e-130, 1e-300, 1e31, 1e80, 1e200, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    Points scaled = OnBall(random, 20);
    for (Vector3d& point : scaled) point *= size;
    EXPECT_TRUE(is_none(scaled)) << size;
  }
  // Nothing is left of a ball that far off.
  Points far = OnBall(random, 20);
  for (Vector3d& point : far) point.x() += 1e14;
  EXPECT_TRUE(is_none(far));
}

TEST(HullWithoutFacets, AnySize_HasFaces) {
  Random random(TestSeed());
  for (const double size : {1e-29, 1e-20, 1e-6, 1e6, 1e20, 1e29}) {
    Points points = OnBall(random, 20);
    for (Vector3d& point : points) point *= size;
    const Hull hull(*HullWithoutFacets(points));
    EXPECT_EQ(SupportFace(hull, random.UnitVector()).size, 3) << size;
  }
}

}  // namespace
}  // namespace dgd_test
