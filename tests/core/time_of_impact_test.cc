// Times of impact that a formula tells, and what a sweep says where there is none.
#include "dgd/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"

namespace dgd {
namespace {

using Point3 = Eigen::Vector3d;

Motion<double> Straight(const Point3& from, const Point3& way) {
  Motion<double> motion;
  motion.start.translation = from;
  motion.translation = way;
  return motion;
}

Motion<double> Turning(const Point3& at, const Point3& rotation) {
  Motion<double> motion;
  motion.start.translation = at;
  motion.rotation = rotation;
  return motion;
}

template <class Set1, class Set2>
TimeOfImpactResult<double> Sweep(const Set1& set_1, const Motion<double>& motion_1, const Set2& set_2,
                                 const Motion<double>& motion_2, const SweepSettings<double>& settings = {}) {
  return dgd_test::AnyPair<double, 3>(dgd_test::Erase(set_1), {}, dgd_test::Erase(set_2), {})
      .TimeOfImpact(motion_1, motion_2, settings);
}

/// Late is wrong; as early as the tolerance, a fraction of a nanometre, takes at these speeds is right.
void ExpectImpact(const TimeOfImpactResult<double>& result, double time, double earliness = 1e-9) {
  EXPECT_EQ(result.status, Status::kTouching);
  EXPECT_LE(result.time, time + 1e-14);
  EXPECT_GE(result.time, time - earliness);
  EXPECT_GE(result.separation, 0);
  EXPECT_LE(result.separation, SweepSettings<double>().tolerance);
  EXPECT_NEAR((result.witness_2 - result.witness_1).norm(), result.separation, 1e-9);
}

TEST(TimeOfImpact, Spheres_HeadOn) {
  const auto ball = Sphere(0.5), other = Sphere(0.25);
  const auto result = Sweep(ball, Straight({0, 0, 0}, {1, 0, 0}), other, Straight({3, 0, 0}, {-2, 0, 0}));
  ExpectImpact(result, 0.75);
  EXPECT_NEAR((result.normal - Point3::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((result.witness_1 - Point3(1.25, 0, 0)).norm(), 0, 1e-9);
}

TEST(TimeOfImpact, Spheres_AskewHitAndMissByAMicrometre) {
  const auto ball = Sphere(0.5);
  const double offset = 1 - 1e-6;
  const auto hit = Sweep(ball, Straight({0, 0, 0}, {0, 0, 0}), ball, Straight({-2, offset, 0}, {4, 0, 0}));
  ExpectImpact(hit, (2 - std::sqrt(1 - offset * offset)) / 4, 1e-7);  // It closes at 6 mm in a time of 1.
  const auto miss = Sweep(ball, Straight({0, 0, 0}, {0, 0, 0}), ball, Straight({-2, 1 + 1e-6, 0}, {4, 0, 0}));
  EXPECT_EQ(miss.status, Status::kSeparated);
  EXPECT_EQ(miss.time, 1);
}

TEST(TimeOfImpact, Boxes_FaceOnFaceInTwoPlanes) {
  const RoundedSet box{Box<double>({0.5, 0.5, 0.5})};
  const auto result = Sweep(box, Straight({0, 0, 0}, {0, 0, 0}), box, Straight({0.3, 0.2, 2}, {0.1, 0, -2}));
  ExpectImpact(result, 0.5);
  EXPECT_LE(result.planes, 2);
}

TEST(TimeOfImpact, Boxes_EdgeOnEdge) {
  const RoundedSet box{Box<double>({0.5, 0.5, 0.5})};
  Motion<double> lower, upper = Straight({0.1, 0.1, 3}, {0, 0, -3});
  lower.start.rotation = Eigen::AngleAxisd(std::numbers::pi / 4, Point3::UnitY()).toRotationMatrix();
  upper.start.rotation = Eigen::AngleAxisd(std::numbers::pi / 4, Point3::UnitX()).toRotationMatrix();
  const auto result = Sweep(box, lower, box, upper);
  ExpectImpact(result, (3 - std::numbers::sqrt2) / 3);
  EXPECT_NEAR((result.normal - Point3::UnitZ()).norm(), 0, 1e-9);
}

TEST(TimeOfImpact, TurningRod_HitsABallAtItsAngle) {
  const RoundedSet rod{Segment<double>(1), 0.1};
  const auto ball = Sphere(0.2);
  Motion<double> turning = Turning({0, 0, 0}, {0, 0, std::numbers::pi / 2});
  // Along x.
  turning.start.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Point3::UnitY()).toRotationMatrix();
  const double angle = 1.2, distance = 0.8;
  const Point3 at(distance * std::cos(angle), distance * std::sin(angle), 0.05);
  const double across = std::sqrt(0.3 * 0.3 - 0.05 * 0.05);
  const double impact = angle - std::asin(across / distance);
  ExpectImpact(Sweep(rod, turning, ball, Straight(at, {0, 0, 0})), impact / (std::numbers::pi / 2));
  // Its other end, after half a turn more; and as the second of the two.
  turning.rotation = {0, 0, -20 * std::numbers::pi};
  ExpectImpact(Sweep(ball, Straight(at, {0, 0, 0}), rod, turning),
               (std::numbers::pi - angle - std::asin(across / distance)) / (20 * std::numbers::pi));
}

TEST(TimeOfImpact, TurnAboutAnotherPoint_IsThatOfTheFrame) {
  // A ball on an arm of 1 m, swung by a quarter turn onto a wall.
  const auto ball = Sphere(0.1);
  const RoundedSet wall{Box<double>({0.5, 1, 1})};
  Motion<double> swing = Turning({0, 1, 0}, {0, 0, -std::numbers::pi / 2});
  swing.center = {0, -1, 0};
  EXPECT_NEAR((swing.At(1).translation - Point3(1, 0, 0)).norm(), 0, 1e-15);
  ExpectImpact(Sweep(ball, swing, wall, Straight({1.3, 0, 0}, {0, 0, 0})), std::asin(0.7) / (std::numbers::pi / 2));
}

TEST(TimeOfImpact, TriangleOnTriangle_FlatSetsOfNoInterior) {
  const RoundedSet floor{Triangle<double>({-1, -1, 0}, {1, -1, 0}, {0, 1, 0})};
  ExpectImpact(Sweep(floor, Straight({0, 0, 0}, {0, 0, 0}), floor, Straight({0.1, 0, 1}, {0, 0, -2})), 0.5);
}

TEST(TimeOfImpact, FarFromTheOrigin_AsNear) {
  const RoundedSet box{Box<double>({0.5, 0.5, 0.5}), 0.1};
  const Point3 far(3e5, -2e5, 1e5);
  SweepSettings<double> settings;
  settings.tolerance = 1e-8;
  const auto result =
      Sweep(box, Straight(far, {0, 0, 0}), box, Straight(far + Point3(0, 0, 2.2), {0, 0, -2}), settings);
  EXPECT_EQ(result.status, Status::kTouching);
  EXPECT_NEAR(result.time, 0.5, 1e-7);
}

TEST(TimeOfImpact, OverlapFromTheStart_IsSaidAtOnce) {
  const auto ball = Sphere(0.5);
  const auto result = Sweep(ball, Straight({0, 0, 0}, {0, 0, 0}), ball, Straight({0.9, 0, 0}, {5, 0, 0}));
  EXPECT_EQ(result.status, Status::kColliding);
  EXPECT_EQ(result.time, 0);
  EXPECT_NEAR(result.separation, -0.1, 1e-12);
  EXPECT_EQ(result.planes, 1);
}

TEST(TimeOfImpact, TouchFromTheStart_IsAnImpactWhereverTheyGo) {
  const RoundedSet box{Box<double>({0.5, 0.5, 0.5})};
  const auto result = Sweep(box, Straight({0, 0, 0}, {0, 0, 0}), box, Straight({0, 0, 1}, {0, 0, 1}));
  EXPECT_EQ(result.status, Status::kTouching);
  EXPECT_EQ(result.time, 0);
}

TEST(TimeOfImpact, NoMotion_NoImpact) {
  const auto ball = Sphere(0.5);
  const auto result = Sweep(ball, {}, ball, Straight({1.01, 0, 0}, {0, 0, 0}));
  EXPECT_EQ(result.status, Status::kSeparated);
  EXPECT_EQ(result.planes, 1);
}

TEST(TimeOfImpact, TooFewPlanes_StillNeverLate) {
  const RoundedSet ellipsoid{Ellipsoid<double>({1, 0.2, 0.5})};
  Motion<double> motion = Straight({3, 0.4, 0}, {-4, 0, 0});
  motion.rotation = {0.5, 1, 2};
  const auto full = Sweep(ellipsoid, Motion<double>(), ellipsoid, motion);
  ASSERT_EQ(full.status, Status::kTouching);
  ASSERT_GT(full.planes, 2);
  SweepSettings<double> settings;
  settings.max_planes = 2;
  const auto stopped = Sweep(ellipsoid, Motion<double>(), ellipsoid, motion, settings);
  EXPECT_EQ(stopped.status, Status::kIterationLimit);
  EXPECT_GT(stopped.time, 0);
  EXPECT_LT(stopped.time, full.time);
}

TEST(TimeOfImpact, NotANumberAnywhere_IsInvalid) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto ball = Sphere(0.5);
  const Motion<double> away = Straight({2, 0, 0}, {0, 0, 0});
  for (const double bad : {nan, inf, -inf}) {
    for (const Motion<double>& motion :
         {Straight({bad, 0, 0}, {0, 0, 0}), Straight({0, 0, 0}, {0, bad, 0}), Turning({0, 0, 0}, {0, 0, bad})}) {
      EXPECT_EQ(Sweep(ball, motion, ball, away).status, Status::kInvalidInput);
      EXPECT_EQ(Sweep(ball, away, ball, motion).status, Status::kInvalidInput);
    }
  }
}

TEST(Motion, Between_TakesTheShortestTurn) {
  Pose<double> start, end;
  start.rotation = Eigen::AngleAxisd(0.4, Point3(1, 2, 3).normalized()).toRotationMatrix();
  end.rotation = Eigen::AngleAxisd(-2.9, Point3(3, 1, -2).normalized()).toRotationMatrix() * start.rotation;
  end.translation = {1, 2, 3};
  const auto motion = Motion<double>::Between(start, end);
  EXPECT_NEAR(motion.rotation.norm(), 2.9, 1e-12);
  EXPECT_NEAR((motion.At(1).rotation - end.rotation).norm(), 0, 1e-12);
  EXPECT_EQ(motion.At(1).translation, end.translation);
  EXPECT_EQ(motion.At(0).rotation, start.rotation);
}

}  // namespace
}  // namespace dgd
