// The sign of a contact's distance, which apps take for whether bodies touch.
#include <gtest/gtest.h>

#include <vector>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

class JustTouching : public testing::Test {
 protected:
  JustTouching() {
    world_.AddGround();
    box_ = &world_.Add(world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.5 + kGap));
    box_->setActivationState(DISABLE_DEACTIVATION);
  }

  /// The distances of the box's contacts after a step.
  std::vector<double> Step() {
    world_.Simulate(TestWorld::kTimeStep);
    std::vector<double> distances;
    for (const btManifoldPoint& point : world_.Points()) distances.push_back(double(point.getDistance()));
    return distances;
  }

  static constexpr double kGap = 1e-5;  // Metres; half of what counts as near.

  TestWorld world_{Route::kConfiguration};
  btRigidBody* box_ = nullptr;
};

// As in space, or where an app moves bodies: there is a gap, however small, and nothing that closes it.
TEST_F(JustTouching, BodyThatHoversOverAnother_DoesNotTouch) {
  world_.world().setGravity(Vec(0, 0, 0));
  box_->setGravity(Vec(0, 0, 0));
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> distances = Step();
    ASSERT_EQ(distances.size(), 4U);
    for (const double distance : distances) EXPECT_NEAR(distance, kGap, 1e-7);
  }
}

// The gap is closed within the first step, and what roundoff leaves of one later carries the weight. In float the box
// often lies at a distance of exactly 0.
TEST_F(JustTouching, BodyThatItsWeightBringsDown_Touches) {
  for (int i = 0; i < 240; ++i) {
    const std::vector<double> distances = Step();
    ASSERT_EQ(distances.size(), 4U);
    for (const double distance : distances) {
      EXPECT_LE(distance, 0) << i;
      EXPECT_GT(distance, -1.01 * kGap) << i;
    }
  }
}

// As in PyBullet's server. The solver would not close a gap that it does not get.
TEST(SolverSlop, BodyThatFalls_LandsOnTheGround) {
  constexpr double kSlop = 1e-5, kSpeed = 4;
  for (const double restitution : {0.0, 1.0}) {
    TestWorld world(Route::kConfiguration);
    world.world().getSolverInfo().m_linearSlop = btScalar(kSlop);
    world.AddGround().setRestitution(btScalar(restitution));
    const double gap = 0.9 * kSpeed * TestWorld::kTimeStep;
    btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.5 + gap));
    box.setRestitution(1);
    box.setLinearVelocity(Vec(0, 0, -kSpeed));
    world.Simulate(TestWorld::kTimeStep);
    for (const btManifoldPoint& point : world.Points()) EXPECT_LT(double(point.getDistance()), 0) << "for apps";
    if (restitution > 0) {
      EXPECT_NEAR(double(box.getLinearVelocity().z()), kSpeed, 1e-3) << "the slop over the time step is 2.4e-3";
      continue;
    }
    EXPECT_NEAR(double(box.getWorldTransform().getOrigin().z()), 0.5, 0.11 * gap);
    for (int step = 0; step < 2; ++step) world.Simulate(TestWorld::kTimeStep);
    EXPECT_NEAR(double(box.getWorldTransform().getOrigin().z()), 0.5, 3 * kSlop);
  }
}

}  // namespace
}  // namespace dgd_test
