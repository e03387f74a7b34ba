// The speed that a rebound is to leave, against what follows from the energy of the flight.
#include "conditioning/restitution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dgd_test {
namespace {

using dgd_bullet::SpeedAfterImpact;

constexpr double kGravity = 9.81;

/// Energy of the parabola through a body's places, for each kilogram: its speed there is half a step's fall less than
/// the stored one and the one after the step, upwards.
double FlightEnergy(double height, double speed_up, double time_step) {
  const double speed = speed_up - kGravity * time_step / 2;
  return speed * speed / 2 + kGravity * height;
}

TEST(SpeedAfterImpact, Elastic_IsTheSpeedOfApproachWhereverInTheStep) {
  for (const double time_step : {1.0 / 60, 1.0 / 240, 1e-3}) {
    for (const double gap : {0.0, 0.3 * 5 * time_step, 5 * time_step, -1e-3}) {
      const auto after = SpeedAfterImpact(1, 5, kGravity * time_step, gap, time_step);
      ASSERT_TRUE(after.has_value());
      EXPECT_NEAR(*after, 5, 1e-12);
    }
  }
}

TEST(SpeedAfterImpact, Inelastic_LeavesTheSquareOfTheCoefficientOfTheEnergy) {
  for (const double time_step : {1.0 / 60, 1.0 / 240, 1e-3}) {
    for (const double restitution : {0.4, 0.8}) {
      const double approach = 4, gap = 0.4 * approach * time_step;
      const auto after = SpeedAfterImpact(restitution, approach, kGravity * time_step, gap, time_step);
      ASSERT_TRUE(after.has_value());
      const double before = FlightEnergy(gap, -approach, time_step);
      // After the step, the body is where its new speed has brought it.
      const double left = FlightEnergy(gap + *after * time_step, *after, time_step);
      EXPECT_NEAR(left, restitution * restitution * before, 1e-12 * before);
    }
  }
}

TEST(SpeedAfterImpact, ReboundBelowTheHeightNow_IsNone) {
  EXPECT_FALSE(SpeedAfterImpact(0.2, 0.3, kGravity / 60, 0.005, 1.0 / 60).has_value());
}

}  // namespace
}  // namespace dgd_test
