// The vertices of two hulls, rotated once: what is farthest among them is what their support functions find.
#include "dgd/solver/placed_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "dgd/shapes/polytope.h"
#include "support/random.h"

namespace dgd_test {
namespace {

template <class S>
struct Corner {
  dgd::Vector3<S> point;
  dgd::VertexId vertex_1, vertex_2;
};

template <class S>
struct PosedHull {
  PosedHull(Random& random, int points)
      : hull([&] {
          std::vector<Eigen::Vector3d> vertices;
          for (int i = 0; i < points; ++i) vertices.push_back(random.UnitVector() + Eigen::Vector3d(1, 2, 3));
          return dgd::Polytope<S>(vertices);
        }()),
        rotation(random.Rotation().cast<S>()) {}

  dgd::Vector3<S> FromCenter(dgd::VertexId vertex) const { return rotation * (hull.Vertex(vertex) - hull.Center()); }
  S Height(const dgd::Vector3<S>& direction) const {
    const dgd::Vector3<S> in_frame = rotation.transpose() * direction;
    return direction.dot(FromCenter(hull.Support(in_frame).feature));
  }

  dgd::Polytope<S> hull;
  dgd::Matrix3<S> rotation;
};

template <class S>
dgd::solver_internal::PlacedVertices<S> Place(const PosedHull<S>& a, const PosedHull<S>& b) {
  dgd::solver_internal::PlacedVertices<S> placed;
  placed.Place(a.hull.Scan(), a.hull.Center(), a.rotation, b.hull.Scan(), b.hull.Center(), b.rotation);
  return placed;
}

template <class S>
class PlacedVertices : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(PlacedVertices, Scalars, );

TYPED_TEST(PlacedVertices, Farthest_IsTheDifferenceOfTheSupportPoints) {
  using S = TypeParam;
  const S tolerance = 32 * std::numeric_limits<S>::epsilon();
  Random random(TestSeed());
  for (int points = 4; points <= 64; points += 3) {
    const PosedHull<S> a(random, points), b(random, 68 - points);
    const auto placed = Place(a, b);
    ASSERT_TRUE(placed.AreThere());
    for (int trial = 0; trial < 20; ++trial) {
      const dgd::Vector3<S> direction = random.UnitVector().cast<S>();
      const auto corner = placed.template Farthest<Corner<S>>(direction);
      const dgd::Vector3<S> point = a.FromCenter(corner.vertex_1) - b.FromCenter(corner.vertex_2);
      EXPECT_LT((corner.point - point).norm(), tolerance);
      EXPECT_NEAR(direction.dot(corner.point), a.Height(direction) + b.Height(-direction), tolerance);
    }
  }
}

TYPED_TEST(PlacedVertices, OfLargeHulls_ThereAreNone) {
  Random random(TestSeed());
  const PosedHull<TypeParam> small(random, 10), large(random, 300);
  EXPECT_TRUE(Place(small, small).AreThere());
  EXPECT_FALSE(Place(small, large).AreThere());
  EXPECT_FALSE(Place(large, small).AreThere());
}

// A flat hull is scanned whatever its size.
TEST(PlacedVerticesOfFlatHull, MoreThanThereIsRoomFor_ThereAreNone) {
  std::vector<Eigen::Vector3d> circle;
  for (int i = 0; i < 100; ++i) circle.emplace_back(std::cos(0.0628 * i), std::sin(0.0628 * i), 0);
  const dgd::Polytope<double> flat(circle);
  ASSERT_NE(flat.Scan(), nullptr);
  ASSERT_GT(flat.Scan()->PaddedSize(), dgd::kMostScannedVertices);
  dgd::solver_internal::PlacedVertices<double> placed;
  const Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  placed.Place(flat.Scan(), flat.Center(), rotation, flat.Scan(), flat.Center(), rotation);
  EXPECT_FALSE(placed.AreThere());
}

}  // namespace
}  // namespace dgd_test
