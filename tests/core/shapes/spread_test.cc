// What cores tell of their reach (SpreadCore), beside how far they do reach.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dgd/shapes.h"
#include "support/random.h"
#include "support/sets/dsf.h"
#include "support/sets/transformed.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> SkewedPoints() {
  Random random(3);
  std::vector<Vector3d> points;
  const Eigen::Matrix3d turn = random.Rotation();
  for (int i = 0; i < 100; ++i) points.push_back(turn * random.UnitVector().cwiseProduct(Vector3d(0.1, 0.5, 2)));
  return points;
}

/// Half the width of a core along a direction, over what its spread says.
template <class Core>
void ExpectWidthsNear(const Core& core, double least, double most) {
  static_assert(dgd::SpreadCore<Core>);
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vector3d direction = random.UnitVector();
    const Vector3d opposite = -direction;
    const double half_width = (core.SupportValue(direction) + core.SupportValue(opposite)) / 2;
    const double of_spread = std::sqrt(direction.dot(core.Spread() * direction));
    EXPECT_GE(half_width, least * of_spread) << direction.transpose();
    EXPECT_LE(half_width, most * of_spread) << direction.transpose();
  }
}

TEST(Spread, OfEllipsoidsAndSegments_IsTheirReach) {
  ExpectWidthsNear(dgd::Ellipsoid<double>({0.1, 0.5, 2}), 1 - 1e-12, 1 + 1e-12);
  ExpectWidthsNear(dgd::Segment<double>(2), 1 - 1e-12, 1 + 1e-12);
}

TEST(Spread, OfOtherShapes_IsAboutTheirReach) {
  ExpectWidthsNear(dgd::Box<double>({0.1, 0.5, 2}), 1, std::sqrt(3));
  ExpectWidthsNear(dgd::Cylinder<double>(0.1, 2), 1, std::sqrt(2));
  ExpectWidthsNear(dgd::Cylinder<double>(2, 0.1), 1, std::sqrt(2));
  ExpectWidthsNear(dgd::Cone<double>(0.1, 4), 0.7, 1.4);
  ExpectWidthsNear(dgd::Cone<double>(2, 0.2), 0.7, 1.4);
  ExpectWidthsNear(dgd::Frustum<double>(0.1, 0.2, 4), 0.7, 1.4);
}

TEST(Spread, OfHulls_IsAboutTheirReachHoweverTheyLie) {
  const std::vector<Vector3d> points = SkewedPoints();
  const dgd::Polytope<double> hull(points);
  ExpectWidthsNear(hull, 0.6, 1.5);
  ExpectWidthsNear(dgd::CoreReference<dgd::Polytope<double>>(hull), 0.6, 1.5);
  ExpectWidthsNear(Dsf<double>(points, 8), 0.6, 2);
  const Eigen::Matrix3d shear = (Eigen::Matrix3d() << 1, 0.5, 0, 0, 2, 0, 0, -0.3, 0.5).finished();
  ExpectWidthsNear(Transformed<dgd::Polytope<double>>(hull, shear, Vector3d(1, 2, 3)), 0.6, 1.5);
}

TEST(Spread, OfACoreThatDoesNotTell_IsOfTheBallInside) {
  const dgd::Triangle<double> triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  static_assert(!dgd::SpreadCore<dgd::Triangle<double>>);
  EXPECT_EQ(dgd::SpreadOf(triangle) * Vector3d(1, 2, 3), Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace dgd_test
