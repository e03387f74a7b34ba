// Newton's step on kinks: of balls of different sizes, whose hull is nearest to the origin between them.
#include "dgd/distance/newton_kink_step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cfenv>
#include <limits>
#include <vector>

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

/// Where the steps from a normal nearby end: along it all balls are level, and no turn that keeps them so is better.
Point Converge(const std::vector<Ball>& balls, Point normal, int steps) {
  for (int i = 0; i < steps; ++i) {
    Point next;
    EXPECT_TRUE(dgd::StepOnKink<double>(normal, TangentsAt(normal), ModelsAt(balls, normal), next));
    EXPECT_NEAR(next.norm(), 1, 1e-15);
    normal = next;
  }
  return normal;
}

TEST(KinkStep, OneBall_ItsOwnNormal) {
  const Point center(0.3, -0.4, -2);
  const Point normal = Converge({{center, 0.5}}, Point(0.2, 0.1, 1).normalized(), 6);
  EXPECT_NEAR((normal + center.normalized()).norm(), 0, 1e-14);
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
  Point next;
  EXPECT_FALSE(dgd::StepOnKink<double>(Point::UnitZ(), TangentsAt(Point::UnitZ()),
                                       ModelsAt({ball, ball}, Point::UnitZ()), next));
}

TEST(KinkStep, NoSecondDerivative_None_AndNotCalculatedWith) {
  const Point normal = Point::UnitZ();
  dgd::PieceModels<double> pieces = ModelsAt({{{-1, 0, -2}, 0.3}, {{1, 0, -2}, 0.3}}, normal);
  pieces[1].curvature.setConstant(std::numeric_limits<double>::quiet_NaN());
  Point next;
  std::feclearexcept(FE_ALL_EXCEPT);
  EXPECT_FALSE(dgd::StepOnKink<double>(normal, TangentsAt(normal), pieces, next));
  EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
}

}  // namespace
}  // namespace dgd_test
