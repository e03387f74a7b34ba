// The expanding polytope: grows to the hull of what it is given, also where points share planes and lines.
#include "dgd/distance/epa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.h"

namespace dgd_test {
namespace {

using Point = Eigen::Vector3d;
using Feature = dgd::DifferencePoint<double, 3>;

constexpr double kRounding = 1e-15;

Feature At(const Point& point) {
  Feature feature;
  feature.point = feature.on_1 = point;
  return feature;
}

/// @param error  Of points, metres.
dgd::EpaPolytope<double> Start(double error = kRounding) {
  return {{At({1, 1, 1}), At({1, -1, -1}), At({-1, 1, -1}), At({-1, -1, 1})}, kRounding, 1, error};
}

// Every square face of the cube gets four corners in one plane, and half of its diagonals are edges already.
TEST(EpaPolytope, CornersOfACube_MakeTheCube) {
  dgd::EpaPolytope<double> polytope = Start();
  EXPECT_NEAR(polytope.Inradius(), 1 / std::sqrt(3.0), 1e-15);
  for (const Point& corner : {Point(-1, -1, -1), Point(-1, 1, 1), Point(1, -1, 1), Point(1, 1, -1)}) {
    EXPECT_TRUE(polytope.Add(At(corner)));
  }
  EXPECT_NEAR(polytope.Inradius(), 1, 1e-15);
  // Nothing of the cube is in front of it any more: corners, points of its faces, of its edges, of its inside.
  for (const Point& point : {Point(1, 1, 1), Point(1, 0.3, 0.2), Point(1, 1, 0), Point(0.5, 0.5, 0.5)}) {
    EXPECT_FALSE(polytope.Add(At(point)));
  }
  EXPECT_NEAR((polytope.NearestTo({1, 0.3, -0.6}).point - Point(1, 0.3, -0.6)).norm(), 0, 1e-15);
  EXPECT_NEAR((polytope.NearestTo({3, 2, 0.5}).point - Point(1, 1, 0.5)).norm(), 0, 1e-15);
}

TEST(EpaPolytope, PointInLineWithAnEdge_LeavesNoGap) {
  dgd::EpaPolytope<double> polytope = Start();
  // On from the edge between (1, 1, 1) and (1, -1, -1), and in the planes of both faces there.
  ASSERT_TRUE(polytope.Add(At({1, 2, 2})));
  EXPECT_NEAR(polytope.Inradius(), 1 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR((polytope.NearestTo({1, 1.5, 1.5}).point - Point(1, 1.5, 1.5)).norm(), 0, 1e-15);
  EXPECT_FALSE(polytope.Add(At({1, 1.9, 1.9})));
}

// A needle's faces know no plane, but where they are.
TEST(EpaPolytope, OnlySlivers_StillHaveANearestPoint) {
  const dgd::EpaPolytope<double> needle({At({0, 0, -1}), At({0, 0, 1}), At({1e-15, 0, 0}), At({0, 1e-15, 0})},
                                        kRounding, 1, kRounding);
  EXPECT_TRUE(needle.IsSliver(needle.Nearest()));
  EXPECT_EQ(needle.Inradius(), 0);
  EXPECT_NEAR((needle.NearestTo({0, 0, 2}).point - Point(0, 0, 1)).norm(), 0, 1e-11);
}

// What a support function in float gives: a place that is below all faces by that is on the surface, and no new point.
TEST(EpaPolytope, PointsWithAnError_MakeASurfaceAllTheSame) {
  constexpr double kError = 1e-6, kStep = 1e-4;
  dgd::EpaPolytope<double> polytope = Start(kError);
  for (const Point& corner : {Point(-1, -1, -1), Point(-1, 1, 1), Point(1, -1, 1), Point(1, 1, -1)}) {
    EXPECT_TRUE(polytope.Add(At(corner)));
  }
  EXPECT_FALSE(polytope.Add(At({1 + kError / 2, 0.1, 0.2})));
  for (const double x : {1 - kError / 2, 1 + kError / 2}) {
    EXPECT_NEAR((polytope.NearestTo({x, 0.3, -0.6}).on_1 - Point(1, 0.3, -0.6)).norm(), 0, kError);
  }
  // Faces much narrower than the root of the error have planes.
  EXPECT_TRUE(polytope.Add(At({1 + kStep, 0, 0})));
  EXPECT_TRUE(polytope.Add(At({1 + 1.5 * kStep, kStep, 0})));
  EXPECT_TRUE(polytope.Add(At({1 + 1.8 * kStep, 0, kStep})));
  EXPECT_NEAR((polytope.NearestTo({2, 0, kStep}).on_1 - Point(1 + 1.8 * kStep, 0, kStep)).norm(), 0, kRounding);
}

// Against the supporting planes of all points: the nearest face's plane is one of the hull's.
TEST(EpaPolytope, GrownWhereItIsNearest_TellsTheHullsInradius) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 40; ++k) points.push_back(random.UnitVector());
    const auto farthest = [&](const Point& direction) {
      return *std::max_element(points.begin(), points.end(),
                               [&](const Point& a, const Point& b) { return direction.dot(a) < direction.dot(b); });
    };
    for (const double sign_x : {1, -1}) points.push_back({sign_x, sign_x, sign_x});
    points.push_back({1, -1, -1});
    points.push_back({-1, 1, -1});
    points.push_back({-1, -1, 1});
    dgd::EpaPolytope<double> polytope = Start();
    double depth = std::numeric_limits<double>::infinity(), bound = 0;
    while (bound < depth - 1e-12) {
      const Point normal = polytope.Nearest().normal;
      const Point support = farthest(normal);
      depth = std::min(depth, normal.dot(support));
      const double last = bound;
      bound = polytope.Inradius();
      ASSERT_GE(bound, last - 1e-12);
      ASSERT_LE(bound, depth + 1e-12);
      if (!polytope.Add(At(support))) break;
    }
    EXPECT_NEAR(polytope.Inradius(), depth, 1e-12);
    for (int k = 0; k < 200; ++k) {
      const Point direction = random.UnitVector();
      EXPECT_GE(direction.dot(farthest(direction)), depth - 1e-12);
    }
  }
}

}  // namespace
}  // namespace dgd_test
