// The speed that a rebound is to leave, against what follows from the energy of the flight; and where bodies rebound.
#include "manifold/restitution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plugin/test_world.h"

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

bool MakeElastic(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*,
                 int, int) {
  point.m_combinedRestitution = 1;
  return true;
}

// Bodies whose restitution only an app's callback sets have contacts ahead of touching, as all that do not rebound.
TEST(Rebound, GapThatTheStepDoesNotClose_IsCrossedFirst) {
  const ContactAddedCallback before = gContactAddedCallback;
  gContactAddedCallback = MakeElastic;
  TestWorld world(Route::kConfiguration);
  btRigidBody& ground = world.AddGround();
  ground.setCollisionFlags(ground.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  constexpr double kSpeed = 1, kGap = 0.013;
  btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.5 + kGap));
  box.setLinearVelocity(Vec(0, 0, -kSpeed));
  double gap = kGap;
  for (int step = 0; step < 20 && box.getLinearVelocity().z() < 0; ++step) {
    gap = double(box.getWorldTransform().getOrigin().z()) - 0.5;
    world.Simulate(TestWorld::kTimeStep);
    if (step > 0) continue;
    EXPECT_EQ(world.Points().size(), 4U) << "within the breaking threshold";
    for (const btManifoldPoint& point : world.Points()) EXPECT_NEAR(double(point.getDistance()), kGap, 1e-6);
  }
  gContactAddedCallback = before;
  EXPECT_LE(gap, 1.2 * kSpeed * TestWorld::kTimeStep) << "rebounds ahead of the ground";
  EXPECT_NEAR(double(box.getLinearVelocity().z()), kSpeed, 0.1);
}

}  // namespace
}  // namespace dgd_test
