// Newton's step for the normal: exact for a ball, quadratic for an ellipsoid, and none over a ridge.
#include "dgd/distance/newton_step.h"

#include <gtest/gtest.h>

#include "dgd/shapes/ellipsoid.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd_test {
namespace {

using Point = Eigen::Vector3d;

/// Of an ellipsoid about `center`, at a unit normal.
dgd::NormalStep<double> StepOn(const Point& semi_axes, const Point& center, const Point& normal) {
  const dgd::Ellipsoid<double> ellipsoid(semi_axes);
  const dgd::CurvedPoint<double> curved = ellipsoid.PieceSupport(0, normal);
  const dgd::Matrix3<double> frame = dgd::FrameAlong<double>(normal);
  Eigen::Matrix<double, 2, 3> tangents;
  tangents << frame.col(0).transpose(), frame.col(1).transpose();
  return dgd::StepFrom<double>(normal, curved.point + center, tangents,
                               tangents * curved.derivative * tangents.transpose());
}

TEST(NormalStep, EllipsoidApart_ConvergesQuadratically) {
  const Point semi_axes(1, 2, 0.5), center(3, -4, 2);
  Point normal = -center.normalized();
  double last_gain = 1;
  for (int i = 0; i < 8; ++i) {
    const dgd::NormalStep<double> step = StepOn(semi_axes, center, normal);
    ASSERT_TRUE(step.is_valid);
    EXPECT_GE(step.gain, 0);
    EXPECT_NEAR(step.next.norm(), 1, 1e-15);
    if (i > 3) {
      EXPECT_LE(step.gain, 0.01 * last_gain + 1e-15);
    }
    last_gain = step.gain;
    normal = step.next;
  }
  const Point nearest = dgd::Ellipsoid<double>(semi_axes).Support(normal).point + center;
  EXPECT_NEAR((nearest.normalized() + normal).norm(), 0, 1e-12);
}

// At the end of its long axis the ellipsoid is farther from its middle than anywhere around: a maximum of the depth.
TEST(NormalStep, OverARidge_HasNone) {
  EXPECT_FALSE(StepOn({1, 2, 0.5}, Point::Zero(), Point::UnitY()).is_valid);
  const dgd::NormalStep<double> at_least = StepOn({1, 2, 0.5}, Point::Zero(), Point::UnitZ());
  EXPECT_TRUE(at_least.is_valid);
  EXPECT_NEAR(at_least.gain, 0, 1e-15);
}

}  // namespace
}  // namespace dgd_test
