// The reference solutions: against closed forms, and against Bullet's built-in at steps so short that they hardly
// matter.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/coulomb.h"
#include "physics/edges.h"
#include "physics/experiment.h"
#include "physics/friction.h"
#include "physics/moving_support.h"
#include "physics/rolling_solid.h"
#include "physics/spinning.h"
#include "physics/steady_disc.h"

namespace dgd_physics {
namespace {

constexpr double kGravity = 9.81;  // m/s^2

Slip Integrate(double duration, double drive, double friction) {
  return IntegrateSlip(
      duration, [drive](double) { return drive; }, [friction](double) { return friction; }, [](double, const Slip&) {});
}

TEST(IntegrateSlip, BelowFriction_Sticks) {
  const Slip slip = Integrate(1, 1.9, 2);
  EXPECT_EQ(slip.velocity, 0);
  EXPECT_EQ(slip.way, 0);
}

TEST(IntegrateSlip, AboveFriction_IsUniformlyAccelerated) {
  const Slip slip = Integrate(2, -5, 2);
  EXPECT_NEAR(slip.velocity, -6, 1e-9);
  EXPECT_NEAR(slip.way, -6, 1e-9);
}

// Pushed for a second, then left: it slides v^2 / (2 f) farther and stops.
TEST(IntegrateSlip, WithoutDrive_SlidesToAStop) {
  const auto push = [](double time) { return time < 1 ? 3.0 : 0.0; };
  const Slip slip = IntegrateSlip(
      5, push, [](double) { return 2.0; }, [](double, const Slip&) {});
  EXPECT_EQ(slip.velocity, 0);
  EXPECT_NEAR(slip.way, 0.5 + 0.25, 1e-4);
}

Disc ThinDisc(double radius) { return {radius, 1e-9, 0, 1, radius * radius / 2, radius * radius / 4}; }

// Omega^2 = 4 g / (R sin(tilt)), and no spin along the normal of the disc.
TEST(RollInPlace, ThinDisc_PrecessesAsInTheTextbook) {
  for (const double tilt : {0.2, 0.6, 1.2}) {
    const SteadyMotion motion = RollInPlace(ThinDisc(0.4), tilt);
    const double precession = std::sqrt(4 * kGravity / (0.4 * std::sin(tilt)));
    // The angular velocity is the precession's part in the disc's plane: along the diameter through the contact.
    EXPECT_NEAR(motion.spin_x, -precession * std::cos(tilt) * std::sin(tilt), 1e-6 * precession) << tilt;
    EXPECT_NEAR(motion.spin_z, precession * std::sin(tilt) * std::sin(tilt), 1e-6 * precession) << tilt;
    EXPECT_NEAR(motion.center_speed, 0, 1e-6) << tilt;
    EXPECT_NEAR(motion.height, 0.4 * std::sin(tilt), 1e-6) << tilt;
  }
}

// At the precession of Euler's disc, the centre of the one in a circle stands still as well.
TEST(RollInCircle, AtThePrecessionInPlace_IsTheSameMotion) {
  const Disc disc = {0.4, 0.05, 0.005, 1, 0.08, 0.041};
  const SteadyMotion in_place = RollInPlace(disc, 0.6);
  const double precession = in_place.spin_z - in_place.spin_x / std::tan(0.6);
  const SteadyMotion circle = RollInCircle(disc, 0.6, precession);
  EXPECT_NEAR(circle.center_speed, 0, 1e-9);
  EXPECT_NEAR(circle.spin_x, in_place.spin_x, 1e-9);
  EXPECT_NEAR(circle.spin_z, in_place.spin_z, 1e-9);
}

// An upright wheel on a wide circle: the tilt balances the centrifugal force and the turning of the spin,
// tan(lean) = 3 v^2 / (2 g r) for a thin disc.
TEST(RollInCircle, WideCircle_LeansAsInTheTextbook) {
  constexpr double kLean = 0.01, kPrecession = 0.05;
  const SteadyMotion motion = RollInCircle(ThinDisc(0.4), std::acos(0.0) - kLean, kPrecession);
  EXPECT_NEAR(1.5 * kPrecession * std::abs(motion.center_speed) / kGravity, std::tan(kLean), 2e-2 * kLean);
}

Solid PrismOf(int sides, double radius, double half_width) {
  Solid solid;
  for (int i = 0; i < sides; ++i) {
    const double angle = 4 * std::acos(0.0) * i / sides;
    for (const double y : {-half_width, half_width})
      solid.corners.emplace_back(radius * std::sin(angle), y, -radius * std::cos(angle));
  }
  solid.inertia = radius * radius * Eigen::Vector3d(0.3, 0.5, 0.3);
  return solid;
}

// From above one corner to above the next the spin gains by the fall, is multiplied at the impact, and loses the same.
TEST(Integrate, WheelOverFiveCorners_HasTheSpinOfTheRimlessWheel) {
  constexpr int kSides = 16;
  constexpr double kRadius = 0.3, kSpeed = 1, kPace = 1e-3;  // m, m/s, s
  const Solid solid = PrismOf(kSides, kRadius, 0.1);
  const double half_angle = 2 * std::acos(0.0) / kSides, side = 2 * kRadius * std::sin(half_angle);
  const double about_corner = 1.5 * kRadius * kRadius;
  const double kept = (0.5 + std::cos(2 * half_angle)) / 1.5;
  const double fall = 2 * kGravity * kRadius * (1 - std::cos(half_angle)) / about_corner;
  double squared = kSpeed * kSpeed / (kRadius * kRadius);
  SolidMotion motion = RollOnLowestCorner(solid, Eigen::Quaterniond::Identity(), Eigen::Vector3d::UnitX(), kSpeed);
  for (int corner = 1; corner <= 5; ++corner) {
    squared = kept * kept * (squared + fall) - fall;
    while (motion.position.x() < corner * side) motion = Integrate(solid, motion, {0, 0, -kGravity}, 1, kPace, 1e-4);
    EXPECT_NEAR(motion.spin.y(), std::sqrt(squared), 2e-3 * std::sqrt(squared)) << corner;
  }
}

TEST(Integrate, CubeThatSlides_StopsByCoulombsLaw) {
  constexpr double kHalf = 0.1, kSpeed = 1, kFriction = 0.3;  // m, m/s
  const Solid solid = PrismOf(4, kHalf * std::sqrt(2.0), kHalf);
  SolidMotion motion{{0, 0, kHalf},
                     Eigen::Quaterniond(Eigen::AngleAxisd(std::acos(0.0) / 2, Eigen::Vector3d::UnitY()))};
  motion.velocity = {kSpeed, 0, 0};
  motion = Integrate(solid, motion, {0, 0, -kGravity}, kFriction, 1);
  EXPECT_NEAR(motion.position.x(), kSpeed * kSpeed / (2 * kFriction * kGravity), 1e-3);
  EXPECT_NEAR(motion.velocity.norm(), 0, 1e-6);
  EXPECT_NEAR(motion.position.z(), kHalf, 1e-5);
}

constexpr double kShortStepRate = 8000;  // Hz

double BuiltinErrorAtShortSteps(Samples (*measure)(const Conditions&)) {
  return RmsError(measure({Narrowphase::kBuiltin, kShortStepRate, true}));
}

// Steps do not explain what is left of these. Bullet in float loses some of it to roundoff.
TEST(Theory, BuiltinComesToItWithShortSteps) {
  EXPECT_LT(BuiltinErrorAtShortSteps(MeasureEulerDisc), 0.02);
  EXPECT_LT(BuiltinErrorAtShortSteps(MeasureDiscCircle), 0.02);
  EXPECT_LT(BuiltinErrorAtShortSteps(MeasureTorsion), 0.005);
  EXPECT_LT(BuiltinErrorAtShortSteps(MeasureFeeder), 0.02);
}

}  // namespace
}  // namespace dgd_physics
