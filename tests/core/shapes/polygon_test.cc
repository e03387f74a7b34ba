#include "dgd/shapes/polygon.h"

#include <cmath>
#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

template <class S>
void CheckPolygon(const Points& points) {
  CheckExpected(dgd::Polygon<S>(points), ExpectedHull<2>(points));
}

Points RandomPoints(Random& random, int count) {
  const double width = random.LogUniform(0.01, 10), height = random.LogUniform(0.01, 10);
  const Vector2d middle = random.InCube().head<2>();
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(middle + Vector2d(width, height).cwiseProduct(random.InCube().head<2>()));
  }
  return points;
}

TEST(Polygon, Contract_HoldsForRandomHulls) {
  Random random(TestSeed());
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const Points points = RandomPoints(random, 3 + random.Below(20));
    CheckPolygon<double>(points);
    CheckPolygon<float>(points);
  }
}

TEST(Polygon, Contract_HoldsForSegmentsAndPoints) {
  CheckPolygon<double>({{1, 2}});
  CheckPolygon<double>({{1, 2}, {1, 2}, {1, 2}});
  CheckPolygon<double>({{0, 0}, {1, 1}, {0.25, 0.25}});
  CheckPolygon<float>({{0, 3}, {0, -1}});
  EXPECT_EQ(dgd::Polygon<double>(Points{{0, 0}, {1, 1}, {0.25, 0.25}}).Inradius(), 0);
}

TEST(Polygon, Vertices_AreTheCornersCounterclockwise) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    const Points points = RandomPoints(random, 3 + random.Below(20));
    const dgd::Polygon<double> polygon(points);
    const dgd::VertexId count = polygon.VertexCount();
    ASSERT_GE(count, 3U);
    for (dgd::VertexId vertex = 0; vertex < count; ++vertex) {
      const Vector2d& here = polygon.Vertex(vertex);
      const Vector2d to = polygon.Vertex((vertex + 1) % count) - here;
      const Vector2d next = polygon.Vertex((vertex + 2) % count) - here;
      EXPECT_GT(to.x() * next.y() - to.y() * next.x(), 0) << i;
    }
  }
  EXPECT_EQ(dgd::Polygon<double>(Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 0}, {0, 0}}).VertexCount(), 4U);
}

TEST(Polygon, CenterAndInradius_AreTheCentroidAndNearlyItsLargestBall) {
  const Points square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_NEAR((dgd::Polygon<double>(square).Center() - Vector2d(1, 1)).norm(), 0, 1e-15);
  EXPECT_LE(dgd::Polygon<double>(square).Inradius(), 1);
  EXPECT_NEAR(dgd::Polygon<double>(square).Inradius(), 1, 1e-13);
  const Points triangle = {{0, 0}, {3, 0}, {0, 3}};
  EXPECT_NEAR((dgd::Polygon<double>(triangle).Center() - Vector2d(1, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR(dgd::Polygon<double>(triangle).Inradius(), std::sqrt(0.5), 1e-13);
}

TEST(Polygon, Constructor_RejectsEmptyAndNonFinitePoints) {
  ExpectRejected([] { return dgd::Polygon<double>(Points{}); }, "at least one point");
  const Points bad = {{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}};
  ExpectRejected([&] { return dgd::Polygon<double>(bad); }, "hull point 1 must be finite; got (1");
}

}  // namespace
}  // namespace dgd_test
