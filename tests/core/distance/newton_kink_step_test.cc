// Newton's step on kinks: of balls of different sizes, whose hull is nearest to the origin between them.
#include "dgd/distance/newton_kink_step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

#include "dgd/shapes/ellipsoid.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd_test {
namespace {

using Point = Eigen::Vector3d;

struct Ball {
  Point center;
  double radius;
};

Eigen::Matrix<double, 2, 3> TangentsAt(const Point& normal) {
  const dgd::Matrix3<double> frame = dgd::FrameAlong<double>(normal);
  Eigen::Matrix<double, 2, 3> tangents;
  tangents << frame.col(0).transpose(), frame.col(1).transpose();
  return tangents;
}

dgd::PieceModels<double> ModelsAt(const std::vector<Ball>& balls, const Point& normal) {
  dgd::PieceModels<double> pieces;
  for (const Ball& ball : balls) {
    pieces[pieces.size++] = {ball.center + ball.radius * normal, ball.radius * Eigen::Matrix2d::Identity(),
                             1 / double(balls.size())};
  }
  return pieces;
}

/// A model with what it refers to.
struct Kink {
  Kink(const Point& at, const dgd::PieceModels<double>& of_pieces)
      : normal(at), tangents(TangentsAt(at)), pieces(of_pieces), model(normal, tangents, pieces) {}
  Kink(const Kink&) = delete;
  Kink& operator=(const Kink&) = delete;

  Point normal;
  Eigen::Matrix<double, 2, 3> tangents;
  dgd::PieceModels<double> pieces;
  dgd::KinkModel<double> model;
};

/// Where the steps from a normal nearby end: along it all balls are level, and no turn that keeps them so is better.
Point Converge(const std::vector<Ball>& balls, Point normal, int steps) {
  for (int i = 0; i < steps; ++i) {
    const dgd::NormalStep<double> step = dgd::StepOnKink(Kink(normal, ModelsAt(balls, normal)).model);
    EXPECT_TRUE(step.is_valid);
    EXPECT_NEAR(step.next.norm(), 1, 1e-15);
    normal = step.next;
  }
  return normal;
}

TEST(KinkStep, OneBall_ItsOwnNormal) {
  const Point center(0.3, -0.4, -2);
  const Point normal = Converge({{center, 0.5}}, Point(0.2, 0.1, 1).normalized(), 6);
  EXPECT_NEAR((normal + center.normalized()).norm(), 0, 1e-14);
}

/// Of an ellipsoid about `center`, at a unit normal.
dgd::NormalStep<double> StepOn(const Point& semi_axes, const Point& center, const Point& normal) {
  const dgd::CurvedPoint<double> curved = dgd::Ellipsoid<double>(semi_axes).PieceSupport(0, normal);
  const Eigen::Matrix<double, 2, 3> tangents = TangentsAt(normal);
  dgd::PieceModels<double> pieces;
  pieces[pieces.size++] = {curved.point + center, tangents * curved.derivative * tangents.transpose(), 1};
  return dgd::StepOnKink(Kink(normal, pieces).model);
}

TEST(KinkStep, OneEllipsoid_ConvergesQuadratically) {
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

TEST(KinkStep, TwoBalls_LevelAndAcrossTheOrigin) {
  const std::vector<Ball> balls = {{{-1, 0.2, -2}, 0.3}, {{1.2, 0.1, -2.1}, 0.5}};
  const Point normal = Converge(balls, Point(0.1, 0.2, 1).normalized(), 7);
  const Point first = balls[0].center + balls[0].radius * normal, second = balls[1].center + balls[1].radius * normal;
  EXPECT_NEAR(normal.dot(first), normal.dot(second), 1e-14);
  // The nearest point of their tangent, were it a line, is along the normal.
  EXPECT_NEAR(normal.dot(first.cross(second).normalized()), 0, 1e-14);
}

TEST(KinkStep, ThreeBalls_TheirCommonPlane) {
  const std::vector<Ball> balls = {{{-1, 0, -2}, 0.3}, {{1, -1, -2.2}, 0.5}, {{0.2, 1, -1.9}, 0.1}};
  const Point normal = Converge(balls, Point(0.2, 0.1, 1).normalized(), 6);
  const double height = normal.dot(balls[0].center) + balls[0].radius;
  for (const Ball& ball : balls) EXPECT_NEAR(normal.dot(ball.center) + ball.radius, height, 1e-14);
}

TEST(KinkStep, PointsAlike_HaveNone) {
  const Ball ball{{0, 0, -2}, 0.5};
  const Kink kink(Point::UnitZ(), ModelsAt({ball, ball}, Point::UnitZ()));
  EXPECT_FALSE(dgd::StepOnKink(kink.model).is_valid);
  EXPECT_FALSE(dgd::StepDownKink(kink.model, 0.5, 1e-9).is_valid);
}

TEST(KinkStep, NoSecondDerivative_None_AndNotCalculatedWith) {
  const Point normal = Point::UnitZ();
  dgd::PieceModels<double> pieces = ModelsAt({{{-1, 0, -2}, 0.3}, {{1, 0, -2}, 0.3}}, normal);
  pieces[1].curvature.setConstant(std::numeric_limits<double>::quiet_NaN());
  std::feclearexcept(FE_ALL_EXCEPT);
  const Kink kink(normal, pieces);
  EXPECT_FALSE(dgd::StepOnKink(kink.model).is_valid);
  EXPECT_FALSE(dgd::StepDownKink(kink.model, 0.5, 1e-9).is_valid);
  EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
}

// Three balls whose common plane the origin is behind, and the highest of their heights.
const std::vector<Ball> kAround = {{{-1, 0, 0.3}, 0.3}, {{1, -1, 0.2}, 0.5}, {{0.2, 1, 0.4}, 0.1}};

double HeightOf(const std::vector<Ball>& balls, const Point& normal) {
  double height = -std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) height = std::max(height, normal.dot(ball.center) + ball.radius);
  return height;
}

// The gain is what the height falls by, but for the model's error of third order.
TEST(KinkStepFromInside, Gain_IsWhatTheHeightFallsBy) {
  for (const double tilt : {0.1, 0.03, 0.01}) {
    const Point level = Converge(kAround, Point(0.02, 0.1, 1).normalized(), 8);
    const Point normal = (level + tilt * Point(0.6, 0.1, 0)).normalized();
    const Kink kink(normal, ModelsAt(kAround, normal));
    const dgd::NormalStep<double> step = dgd::StepDownKink(kink.model, tilt, 0.0);
    ASSERT_TRUE(step.is_valid);
    const double gain = HeightOf(kAround, normal) - kink.model.Height() + step.gain;
    EXPECT_GT(gain, 0.1 * tilt);
    EXPECT_NEAR(HeightOf(kAround, normal) - HeightOf(kAround, step.next), gain, 2 * tilt * tilt);
  }
}

// Of points, the height over an origin inside of their hull is concave across them: there is no minimum, but a way
// down.
TEST(KinkStepFromInside, AgainstTheCurvature_GoesDownAsFarAsItMay) {
  const std::vector<Ball> points = {{{-1, 0, 1}, 0}, {{1, 0, 1}, 0}};
  const Point normal = Point(0, 0.1, 1).normalized();
  const Kink kink(normal, ModelsAt(points, normal));
  for (const double reach : {0.5, 0.1}) {
    const dgd::NormalStep<double> step = dgd::StepDownKink(kink.model, reach, 1e-9);
    ASSERT_TRUE(step.is_valid);
    EXPECT_NEAR(std::acos(step.next.dot(normal)), std::atan(reach), 1e-12);
    EXPECT_LT(HeightOf(points, step.next), HeightOf(points, normal));
    EXPECT_GT(step.gain, 0);
  }
  const dgd::NormalStep<double> not_worth_it = dgd::StepDownKink(kink.model, 0.5, 1.0);
  EXPECT_EQ((not_worth_it.next - normal).norm(), 0);
  EXPECT_NEAR(not_worth_it.gain, 0, 1e-15);
}

}  // namespace
}  // namespace dgd_test
