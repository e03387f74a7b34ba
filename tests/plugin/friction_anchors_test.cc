// What the option friction_anchors holds, and what it must let go.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dgd_bullet/options.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

class FrictionAnchors : public testing::Test {
 protected:
  static dgd_bullet::Options With(bool anchors) {
    dgd_bullet::Options options;
    options.friction_anchors = anchors;
    return options;
  }

  static void UseTwoFrictionDirections(TestWorld& world) {
    world.world().getSolverInfo().m_numIterations = 50;
    world.world().getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  }

  /// A box on a slope, on its own for so many seconds; how far it slides, metres.
  static double SlideOnSlope(double slope, double seconds, bool anchors) {
    TestWorld world(Route::kConfiguration, With(anchors));
    UseTwoFrictionDirections(world);
    world.AddGround();
    world.world().setGravity(Vec(9.81 * std::sin(slope), 0, -9.81 * std::cos(slope)));
    btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.25)), 1, Vec(0, 0, 0.25));
    box.setActivationState(DISABLE_DEACTIVATION);
    world.Simulate(seconds);
    return double(box.getWorldTransform().getOrigin().x());
  }
};

// Blocks with gaps between them, each on two: on Bullet's narrowphase, and on ours without anchors, they creep apart.
double CreepOfPyramid(const dgd_bullet::Options& options) {
  constexpr int kRows = 6;
  TestWorld world(Route::kConfiguration, options);
  world.world().getSolverInfo().m_numIterations = 50;
  world.world().getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  world.AddGround();
  auto& box = world.Make<btBoxShape>(Vec(0.25, 0.25, 0.25));
  std::vector<btRigidBody*> blocks;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kRows - row; ++i) {
      blocks.push_back(&world.Add(box, 1, Vec(0.55 * (i - 0.5 * (kRows - row - 1)), 0, 0.25 + 0.5 * row)));
      blocks.back()->setActivationState(DISABLE_DEACTIVATION);
    }
  }
  world.Simulate(5);
  std::vector<btVector3> places;
  for (const btRigidBody* block : blocks) places.push_back(block->getWorldTransform().getOrigin());
  world.Simulate(10);
  double farthest = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    farthest = std::max(farthest, double((blocks[i]->getWorldTransform().getOrigin() - places[i]).length()));
  }
  return farthest;
}

TEST_F(FrictionAnchors, Pyramid_DoesNotCreep) {
  const double held = CreepOfPyramid(With(true)), free = CreepOfPyramid(With(false));
  EXPECT_LT(held, 2e-4);
  EXPECT_LT(held, 0.2 * free) << free;
}

// Friction 0.5, of bodies that Bullet gives 0.5 each and multiplies: 0.25. Below, the box stays; above, it slides as
// far as g (sin - mu cos) makes it, anchored or not.
TEST_F(FrictionAnchors, BoxOnSlope_StaysBelowTheFrictionAngleAndSlidesAbove) {
  EXPECT_LT(std::abs(SlideOnSlope(0.2, 5, true)), 1e-4);
  const double slope = 0.4, seconds = 1;
  const double expected = 0.5 * 9.81 * (std::sin(slope) - 0.25 * std::cos(slope)) * seconds * seconds;
  EXPECT_NEAR(SlideOnSlope(slope, seconds, true), expected, 0.03 * expected);
  EXPECT_NEAR(SlideOnSlope(slope, seconds, false), expected, 0.03 * expected);
}

// What Bullet's own anchors would hold back by where it stood.
TEST_F(FrictionAnchors, RollingBodies_RollAsFarAsWithout) {
  for (const bool is_ball : {true, false}) {
    double way[2] = {};
    for (const bool anchors : {true, false}) {
      TestWorld world(Route::kConfiguration, With(anchors));
      UseTwoFrictionDirections(world);
      world.AddGround();
      btConvexShape& shape = is_ball ? static_cast<btConvexShape&>(world.Make<btSphereShape>(btScalar(0.25)))
                                     : world.Make<btCylinderShape>(Vec(0.25, 0.3, 0.25));
      btRigidBody& wheel = world.Add(shape, 1, Vec(-2, 0, 0.25));
      wheel.setActivationState(DISABLE_DEACTIVATION);
      wheel.setLinearVelocity(Vec(1, 0, 0));
      wheel.setAngularVelocity(Vec(0, 4, 0));
      world.Simulate(3);
      way[anchors ? 0 : 1] = double(wheel.getWorldTransform().getOrigin().x()) + 2;
    }
    EXPECT_NEAR(way[0], 3, 0.03) << is_ball;
    EXPECT_NEAR(way[0], way[1], 0.003) << is_ball;
  }
}

// A platform that moves carries what stands on it, and the box is held to the platform, not to the world.
TEST_F(FrictionAnchors, BoxOnMovingPlatform_RidesAlong) {
  TestWorld world(Route::kConfiguration, With(true));
  UseTwoFrictionDirections(world);
  btRigidBody& platform = world.Add(world.Make<btBoxShape>(Vec(2, 2, 0.25)), 0, Vec(0, 0, -0.25));
  platform.setCollisionFlags(platform.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  platform.setActivationState(DISABLE_DEACTIVATION);
  btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.25, 0.25, 0.25)), 1, Vec(0, 0, 0.25));
  box.setActivationState(DISABLE_DEACTIVATION);
  double time = 0;
  for (int step = 0; step < 480; ++step) {
    time += TestWorld::kTimeStep;
    btTransform pose = btTransform::getIdentity();
    pose.setOrigin(Vec(0.2 * (1 - std::cos(time)), 0, -0.25));
    platform.setWorldTransform(pose);
    world.Simulate(TestWorld::kTimeStep);
  }
  EXPECT_NEAR(double(box.getWorldTransform().getOrigin().x()), 0.2 * (1 - std::cos(time)), 5e-3);
}

// As games do that follow a server: place and velocity are set to what another program computes. The box sticks before
// and after. What the velocity does not explain of the way is no slip, and is not taken back.
TEST_F(FrictionAnchors, BoxThatTheAppMovesAside_StaysWhereItIsPut) {
  constexpr int kMoves = 20, kStepsBetween = 10;
  constexpr double kWay = 3e-4;     // Metres; within what recycled contacts may slide.
  constexpr double kSpeed = 0.007;  // m/s; friction stops it within the step.
  TestWorld world(Route::kConfiguration, With(true));
  UseTwoFrictionDirections(world);
  world.AddGround();
  btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.25)), 1, Vec(0, 0, 0.25));
  box.setActivationState(DISABLE_DEACTIVATION);
  world.Simulate(0.5);
  const double start = double(box.getWorldTransform().getOrigin().x());
  for (int i = 0; i < kMoves; ++i) {
    box.getWorldTransform().getOrigin() += Vec(kWay, 0, 0);
    box.setLinearVelocity(Vec(kSpeed, 0, 0));
    world.Simulate(kStepsBetween * TestWorld::kTimeStep);
  }
  EXPECT_NEAR(double(box.getWorldTransform().getOrigin().x()) - start, kMoves * kWay, 1e-5);
}

constexpr double kBeltSpeed = 0.5;  // m/s

// As Bullet's users make conveyor belts: the contact's surface moves, the body does not.
bool MakeBelt(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
              int) {
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  point.m_lateralFrictionDir1 = Vec(1, 0, 0);
  point.m_lateralFrictionDir2 = Vec(0, 1, 0);
  point.m_contactMotion1 = btScalar(kBeltSpeed);
  return true;
}

TEST_F(FrictionAnchors, BoxOnBelt_IsCarriedAsFarAsWithout) {
  const ContactAddedCallback before = gContactAddedCallback;
  gContactAddedCallback = MakeBelt;
  double way[2] = {};
  for (const bool anchors : {true, false}) {
    TestWorld world(Route::kConfiguration, With(anchors));
    UseTwoFrictionDirections(world);
    world.world().getSolverInfo().m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
    btRigidBody& ground = world.AddGround();
    ground.setCollisionFlags(ground.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.25, 0.25, 0.25)), 1, Vec(0, 0, 0.25));
    box.setActivationState(DISABLE_DEACTIVATION);
    world.Simulate(3);
    way[anchors ? 0 : 1] = std::abs(double(box.getWorldTransform().getOrigin().x()));
  }
  gContactAddedCallback = before;
  // Friction 0.25 g brings it to the belt's speed within 0.2 s and 5 cm.
  EXPECT_NEAR(way[0], 3 * kBeltSpeed - 0.05, 0.01);
  EXPECT_NEAR(way[0], way[1], 0.001);
}

}  // namespace
}  // namespace dgd_test
