// The simplex of GJK against triangles whose nearest points can be written down, degenerate ones among them.
#include "dgd/distance/gjk_simplex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/random.h"

namespace dgd_test {
namespace {

using Point = Eigen::Vector3d;
using Feature = dgd::DifferencePoint<double, 3>;

Feature At(const Point& point) {
  Feature feature;
  feature.point = point;
  feature.on_1 = 2 * point;  // Any affine image: combinations must carry it along.
  return feature;
}

dgd::GjkSimplex<double> SimplexOf(const Point& a, const Point& b, const Point& c) { return {{At(a), At(b), At(c)}, 3}; }

TEST(GjkSimplex, OriginOverEachFeature_KeepsThatFeatureAlone) {
  const auto inside = SimplexOf({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  EXPECT_EQ(inside.Size(), 3U);
  EXPECT_NEAR((inside.Nearest() - Point(0, 0, 2)).norm(), 0, 1e-15);
  EXPECT_NEAR((inside.Normal() - Point(0, 0, -1)).norm(), 0, 1e-15);
  EXPECT_NEAR((inside.Combination().on_1 - Point(0, 0, 4)).norm(), 0, 1e-15);

  const auto side = SimplexOf({-1, 1, 2}, {1, 1, 2}, {0, 5, 2});
  EXPECT_EQ(side.Size(), 2U);
  EXPECT_NEAR((side.Nearest() - Point(0, 1, 2)).norm(), 0, 1e-15);
  EXPECT_NEAR((side.Normal() + Point(0, 1, 2).normalized()).norm(), 0, 1e-15);

  const auto corner = SimplexOf({1, 1, 2}, {5, 2, 2}, {2, 5, 2});
  EXPECT_EQ(corner.Size(), 1U);
  EXPECT_EQ(corner.Nearest(), Point(1, 1, 2));
}

TEST(GjkSimplex, DegenerateTriangles_AreSegmentsAndPoints) {
  EXPECT_NEAR((SimplexOf({-1, 0, 1}, {0.5, 0, 1}, {3, 0, 1}).Nearest() - Point(0, 0, 1)).norm(), 0, 1e-15);
  EXPECT_EQ(SimplexOf({1, 2, 3}, {1, 2, 3}, {1, 2, 3}).Nearest(), Point(1, 2, 3));
}

TEST(GjkSimplex, AddedPoint_NearestIsThatOfWhatWasKeptWithIt) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const auto draw = [&]() -> Point { return random.InCube() + Point(0, 0, 1.5); };
    dgd::GjkSimplex<double> simplex = SimplexOf(draw(), draw(), draw());
    const Point added = draw();
    std::vector<Point> points = {added};
    for (std::size_t k = 0; k < simplex.Size(); ++k) points.push_back(simplex[k].point);
    const double before = simplex.Nearest().norm();
    ASSERT_FALSE(simplex.HoldsOriginWith(added));
    simplex.Add(At(added));
    for (int k = 0; k < 300; ++k) {
      Point sum = Point::Zero();
      double weights = 0;
      for (const Point& point : points) {
        const double weight = random.Uniform(0, 1);
        sum += weight * point;
        weights += weight;
      }
      EXPECT_LE(std::min(before, simplex.Nearest().norm()), (sum / weights).norm() + 1e-12);
    }
  }
}

TEST(GjkSimplex, TetrahedronAroundTheOrigin_IsRecognisedWhicheverWayItTurns) {
  const Point a(0.6, 0, -0.5), b(-0.5, 0.8, -0.5), c(-0.5, -0.8, -0.5);
  const auto base = SimplexOf(a, b, c);
  ASSERT_EQ(base.Size(), 3U);
  EXPECT_TRUE(base.HoldsOriginWith({0, 0, 1}));
  EXPECT_TRUE(SimplexOf(b, a, c).HoldsOriginWith({0, 0, 1}));
  EXPECT_FALSE(base.HoldsOriginWith({0, 0, -1}));
  EXPECT_FALSE(base.HoldsOriginWith({5, 0, 1}));
}

}  // namespace
}  // namespace dgd_test
