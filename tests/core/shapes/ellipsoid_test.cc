#include "dgd/shapes/ellipsoid.h"

#include <cmath>
#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

template <class S>
void CheckEllipsoid(const Vector3d& semi_axes) {
  const dgd::Vector3<S> axes = semi_axes.cast<S>();
  CheckShape(dgd::Ellipsoid<S>(axes), {.type = CoreType::kEllipsoid, .size = axes.template cast<double>()}, 0.0);
}

TEST(Ellipsoid, Contract_HoldsForSolidAndFlatOnes) {
  for (const Vector3d& axes : {Vector3d(1, 1, 1), Vector3d(0.1, 2, 30), Vector3d(1, 0, 2), Vector3d(0, 0, 3),
                               Vector3d(0, 0, 0), Vector3d(1e-6, 2e-6, 1e-6), Vector3d(1, 1, 1e-6)}) {
    SCOPED_TRACE(axes.transpose());
    CheckEllipsoid<double>(axes);
    CheckEllipsoid<float>(axes);
  }
}

TEST(Ellipse, Contract_HoldsForSolidAndFlatOnes) {
  for (const Vector2d& axes : {Vector2d(1, 1), Vector2d(0.1, 30), Vector2d(1, 0), Vector2d(0, 0), Vector2d(1e-6, 1)}) {
    SCOPED_TRACE(axes.transpose());
    const auto height = [axes](const Vector2d& direction) { return axes.cwiseProduct(direction).norm(); };
    CheckExpected(dgd::Ellipse<double>(axes), {height, 2 * axes.maxCoeff(), 2 * axes.maxCoeff()});
  }
}

// Any length of the direction, down to where squares, and products with the axes, are no longer numbers.
TEST(Ellipsoid, Support_DoesNotDependOnTheDirectionsLength) {
  const dgd::Ellipsoid<double> ellipsoid({1e-6, 2, 30});
  const Vector3d direction(0.3, -0.4, 0.5);
  const dgd::CurvedPoint<double> usual = ellipsoid.PieceSupport(0, direction);
  for (const int power : {-900, -600, 600, 900}) {
    const double length = std::ldexp(1.0, power);
    EXPECT_EQ(ellipsoid.Support(length * direction).point, usual.point) << power;
    EXPECT_EQ(ellipsoid.PieceSupport(0, length * direction).derivative * length, usual.derivative) << power;
  }
}

// The nearest point of the border, by going out from it along the normal; also where the centre of curvature is near.
TEST(Ellipsoid, Distance_IsRightToRoundingNearAndFar) {
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    const Vector3d axes(random.LogUniform(1e-3, 1), random.LogUniform(1e-3, 1), random.LogUniform(1e-3, 1));
    const dgd::Ellipsoid<double> ellipsoid(axes);
    const Vector3d normal = random.UnitVector();
    const double way = random.LogUniform(1e-12, 1e6);
    const double reach = axes.maxCoeff();
    EXPECT_NEAR(ellipsoid.Distance(ellipsoid.Support(normal).point + way * normal), way, 16e-16 * (reach + way))
        << axes.transpose() << " along " << normal.transpose();
  }
}

// Found by fuzzing, with an axis of 7e-311 m: an infinite distance.
TEST(Ellipsoid, Distance_OfAxesTooTinyToSquare_IsThatToTheCentre) {
  const Vector2d point(4.517578125, 3.796875);
  for (int power = -20; power >= -323; power -= 3) {
    const double axis = std::pow(10.0, power);
    EXPECT_NEAR(dgd::Ellipse<double>({0, axis}).Distance(point), point.norm(), 1e-15) << axis;
    EXPECT_NEAR(dgd::Ellipse<double>({axis, 2 * axis}).Distance(point), point.norm(), 1e-15) << axis;
  }
}

TEST(Ellipsoid, Constructor_RejectsBadAxesNamingThem) {
  ExpectRejected(
      [] {
        return dgd::Ellipsoid<double>({1, -2.5, 1});
      },
      "ellipsoid semi-axis must be finite and >= 0, in metres; got -2.5");
  ExpectRejected([] { return dgd::Ellipsoid<double>({1, 1, std::numeric_limits<double>::quiet_NaN()}); }, "nan");
  ExpectRejected([] { return dgd::Ellipse<double>({std::numeric_limits<double>::infinity(), 1}); }, "inf");
}

}  // namespace
}  // namespace dgd_test
