#include "support/sets/dsf.h"

#include <cmath>
#include <limits>

#include "support/random_sets.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

template <class S>
void CheckDsf(const Points& points, double exponent) {
  const dgd::ConvexHull hull = dgd::BuildConvexHull(points);
  CheckShape(Dsf<S>(points, exponent),
             {.type = CoreType::kDsf, .points = hull.vertices, .exponent = exponent, .center = hull.center});
}

Points Tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

TEST(Dsf, Contract_HoldsForRoundAndSharpOnes) {
  Random random(TestSeed());
  const Points random_points = RandomHull(random, 12, 0.4, 0).points;
  Points far_away = Tetrahedron();
  for (Vector3d& point : far_away) point = 1e-3 * point + Vector3d(3, -2, 1);
  for (const double exponent : {2.5, 8.0, 40.0}) {
    SCOPED_TRACE(exponent);
    CheckDsf<double>(Tetrahedron(), exponent);
    CheckDsf<double>(random_points, exponent);
    CheckDsf<double>(far_away, exponent);
    CheckDsf<float>(random_points, exponent);
  }
}

// For a cross-polytope of six unit vertices and even p, the support function is the p-norm itself.
TEST(Dsf, Support_IsThePNormForTheCrossPolytope) {
  const Points cross = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Dsf<double> dsf(cross, 4);
  const Vector3d direction(1, -2, 0.5);
  const double norm = std::pow(direction.array().pow(4).sum(), 0.25);
  EXPECT_NEAR(dsf.SupportValue(direction), norm, 1e-15);
  const Vector3d gradient = direction.array().pow(3) / std::pow(norm, 3);
  EXPECT_NEAR((dsf.Support(direction).point - gradient).norm(), 0, 1e-15);
  // The dual ball is that of the 4/3-norm: this point is on it.
  EXPECT_NEAR(gradient.cwiseAbs().array().pow(4.0 / 3).sum(), 1, 1e-15);
}

TEST(Dsf, Support_DoesNotDependOnTheDirectionsLength) {
  const Dsf<double> dsf(Tetrahedron(), 100);
  const Vector3d direction(0.3, -0.4, 0.5);
  const dgd::CurvedPoint<double> usual = dsf.PieceSupport(0, direction);
  for (const int power : {-1000, -600, 600, 900}) {
    const double length = std::ldexp(1.0, power);
    EXPECT_EQ(dsf.Support(length * direction).point, usual.point) << power;
    EXPECT_EQ(dsf.PieceSupport(0, length * direction).derivative * length, usual.derivative) << power;
  }
}

TEST(Dsf, Set_ContainsThePolytopeAndComesNearIt) {
  Random random(TestSeed());
  const Points points = RandomHull(random, 30, 2, 0).points;
  const dgd::ConvexHull hull = dgd::BuildConvexHull(points);
  for (const double exponent : {3.0, 30.0, 1000.0}) {
    const Dsf<double> dsf(points, exponent);
    const double factor = std::pow(static_cast<double>(hull.vertices.size()), 1 / exponent);
    for (const Vector3d& direction : Directions(random)) {
      const double polytope = dgd::SupportValueOf(hull, direction) - direction.dot(hull.center);
      const double value = dsf.SupportValue(direction) - direction.dot(hull.center);
      EXPECT_GE(value, polytope - 1e-15);
      EXPECT_LE(value, factor * polytope + 1e-15);
    }
  }
}

TEST(Dsf, Constructor_RejectsFlatPointsAndBadExponents) {
  const Points flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  ExpectRejected([&] { return Dsf<double>(flat, 3); }, "must not be in one plane");
  ExpectRejected([&] { return Dsf<double>(flat, 3); }, "dimension 2");
  ExpectRejected([] { return Dsf<double>(Tetrahedron(), 2); }, "dsf exponent must be finite and > 2; got 2.0");
  ExpectRejected([] { return Dsf<double>(Tetrahedron(), std::numeric_limits<double>::quiet_NaN()); }, "nan");
  ExpectRejected([] { return Dsf<double>(Tetrahedron(), std::numeric_limits<double>::infinity()); }, "inf");
  ExpectRejected([] { return Dsf<double>(Points{}, 3); }, "at least one point");
}

}  // namespace
}  // namespace dgd_test
