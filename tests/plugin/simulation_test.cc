// Whole simulations: bodies come to rest where they should, stay there, and do the same twice. What an app expects of
// flight and bounce is the built-in narrowphase's behaviour, which runs beside ours.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

class Simulation : public testing::TestWithParam<Route> {
 protected:
  TestWorld world_{GetParam()};
};

// The contact with the next box, ahead of its time, has the ball's arm of when they touch.
TEST_P(Simulation, BallOverFlushBoxes_KeepsItsSpeed) {
  constexpr double kRadius = 0.07, kSpeed = 5, kHalfTile = 0.3;
  auto& tile = world_.Make<btBoxShape>(Vec(kHalfTile, 1, 0.2));
  for (int i = -2; i < 18; ++i) world_.Add(tile, 0, Vec((2 * i + 1) * kHalfTile, 0, -0.2)).setFriction(1);
  btRigidBody& ball = world_.Add(world_.Make<btSphereShape>(btScalar(kRadius)), 1, Vec(0, 0, kRadius));
  ball.setFriction(1);
  ball.setLinearVelocity(Vec(kSpeed, 0.1, 0));
  ball.setAngularVelocity(Vec(-0.1 / kRadius, kSpeed / kRadius, 0));
  world_.Simulate(2);
  EXPECT_NEAR(double(ball.getLinearVelocity().x()), kSpeed, 0.01 * kSpeed);
  EXPECT_NEAR(double(ball.getWorldTransform().getOrigin().z()), kRadius, 1e-3);
}

/// Dropped flat from 10 cm, a body must lie still at `height` after five seconds, asleep.
void ExpectRest(TestWorld& world, btConvexShape& shape, double height) {
  btRigidBody& body = world.Add(shape, 1, Vec(0.3, -0.2, height + 0.1));
  world.Simulate(5);
  ASSERT_TRUE(IsFinite(body.getWorldTransform()));
  const btVector3& position = body.getWorldTransform().getOrigin();
  EXPECT_NEAR(double(position.z()), height, 0.001);
  EXPECT_NEAR(double(position.x()), 0.3, 0.002);
  EXPECT_NEAR(double(position.y()), -0.2, 0.002);
  EXPECT_FALSE(body.isActive()) << "not asleep: " << body.getLinearVelocity().length() << " m/s, "
                                << body.getAngularVelocity().length() << " rad/s";
  EXPECT_GE(double(body.getWorldTransform().getBasis()[2].z()), 0.9999) << "fell over";
  EXPECT_EQ(world.statistics().Fallbacks(), 0U);
}

TEST_P(Simulation, Box_ComesToRest) {
  world_.AddGround();
  ExpectRest(world_, world_.Make<btBoxShape>(Vec(0.5, 0.4, 0.3)), 0.3);
}

TEST_P(Simulation, Hull_ComesToRest) {
  world_.AddGround();
  auto& prism = world_.Keep(MakePrism(7, 0.5, 0.3));
  ExpectRest(world_, prism, 0.3 + double(prism.getMargin()));
}

TEST_P(Simulation, Cylinder_ComesToRestUpright) {
  world_.AddGround();
  ExpectRest(world_, world_.Make<btCylinderShapeZ>(Vec(0.4, 0.4, 0.3)), 0.3);
}

TEST_P(Simulation, Cylinder_ComesToRestLying) {
  world_.AddGround();
  ExpectRest(world_, world_.Make<btCylinderShapeX>(Vec(0.5, 0.3, 0.3)), 0.3);
}

TEST_P(Simulation, Capsule_ComesToRestLying) {
  world_.AddGround();
  ExpectRest(world_, world_.Make<btCapsuleShapeX>(btScalar(0.3), btScalar(0.8)), 0.3);
}

TEST_P(Simulation, Cone_ComesToRestOnItsBase) {
  world_.AddGround();
  auto& cone = world_.Make<btConeShapeZ>(btScalar(0.5), btScalar(0.7));
  ExpectRest(world_, cone, 0.35 + double(cone.getMargin()));
}

TEST_P(Simulation, Sphere_ComesToRest) {
  world_.AddGround();
  ExpectRest(world_, world_.Make<btSphereShape>(btScalar(0.4)), 0.4);
}

TEST_P(Simulation, SmallBody_ComesToRest) {
  world_.AddGround();
  auto& box = world_.Make<btBoxShape>(Vec(0.03, 0.02, 0.02));
  ExpectRest(world_, box, 0.02);
}

TEST_P(Simulation, StackOfFiveBoxes_Stands) {
  world_.AddGround();
  auto& box = world_.Make<btBoxShape>(Vec(0.25, 0.25, 0.25));
  std::vector<btRigidBody*> stack;
  for (int i = 0; i < 5; ++i) stack.push_back(&world_.Add(box, 1, Vec(0, 0, 0.25 + 0.51 * i)));
  world_.Simulate(8);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const btVector3& position = stack[i]->getWorldTransform().getOrigin();
    EXPECT_NEAR(double(position.z()), 0.25 + 0.5 * double(i), 0.005) << "box " << i;
    EXPECT_LE(std::hypot(double(position.x()), double(position.y())), 0.005) << "box " << i;
    EXPECT_FALSE(stack[i]->isActive()) << "box " << i;
  }
}

// Awake, since sleep hides a sway: if the point that carries most is not the first of its manifold, this tower's boxes
// sway at up to 120 mm/s.
TEST_P(Simulation, TowerOfTwentyBoxes_StandsStill) {
  world_.AddGround();
  world_.world().getSolverInfo().m_numIterations = 50;
  world_.world().getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  auto& box = world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.25));
  std::vector<btRigidBody*> tower;
  for (int i = 0; i < 20; ++i) {
    tower.push_back(&world_.Add(box, 1, Vec(0, 0, 0.25 + 0.5 * i)));
    tower.back()->setActivationState(DISABLE_DEACTIVATION);
  }
  world_.Simulate(10);
  double fastest = 0;
  for (int step = 0; step < 240; ++step) {
    world_.Simulate(TestWorld::kTimeStep);
    for (const btRigidBody* body : tower) fastest = std::max(fastest, double(body->getLinearVelocity().length()));
  }
  EXPECT_LE(fastest, 0.02);  // Where the tower sways, as on the built-in narrowphase, it is 0.06 and more.
}

/// A box of a metre on the edge of a static one, along y at x = 0; its centre is `beyond` it. Where it is after five
/// seconds.
btTransform FiveSecondsOnALedge(Route route, double beyond, double time_step) {
  TestWorld world(route);
  world.Add(world.Make<btBoxShape>(Vec(2, 2, 0.5)), 0, Vec(-2, 0, -0.5));
  btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(beyond, 0, 0.5));
  box.setActivationState(DISABLE_DEACTIVATION);  // Sleep would hide a slow fall.
  const int steps = static_cast<int>(std::lround(5 / time_step));
  for (int i = 0; i < steps; ++i) world.world().stepSimulation(btScalar(time_step), 0);
  EXPECT_TRUE(IsFinite(box.getWorldTransform()));
  EXPECT_EQ(world.statistics().Fallbacks(), 0U);
  return box.getWorldTransform();
}

// Edges that were rounded by the margin held nothing within four centimetres of the ledge's end.
TEST_P(Simulation, BoxOnALedge_StandsOrFallsByWhereItsCentreIs) {
  for (const double time_step : {1.0 / 60, 1.0 / 240}) {
    for (const double overhang : {0.005, 0.02, 0.038}) {
      SCOPED_TRACE(std::to_string(overhang) + " m at " + std::to_string(1 / time_step) + " Hz");
      const btTransform inside = FiveSecondsOnALedge(GetParam(), -overhang, time_step);
      // With ten iterations at 60 Hz it creeps inwards by 0.3 mm/s; outwards by as much and more on the built-in.
      EXPECT_NEAR(double(inside.getOrigin().x()), -overhang, 0.003);
      EXPECT_NEAR(double(inside.getOrigin().z()), 0.5, 0.001);
      EXPECT_GE(double(inside.getBasis()[2].z()), 0.9999);
      const btTransform outside = FiveSecondsOnALedge(GetParam(), overhang, time_step);
      EXPECT_LE(double(outside.getOrigin().z()), -1);
    }
  }
}

// A tilted body lands on an edge or corner, tumbles, and ends on a face: every normal on the way counts.
TEST_P(Simulation, TumblingBodies_EndAtRestOnTheGround) {
  world_.AddGround();
  Random random(5);
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.6);
  std::vector<btRigidBody*> bodies;
  std::vector<const ZooShape*> shapes;
  for (const ZooShape& shape : zoo) {
    // A triangle has no inertia, and Bullet has no bounding box for a Minkowski sum's child transforms.
    if (shape.name == "Triangle" || shape.name == "MinkowskiSum") continue;
    const auto place = static_cast<double>(bodies.size());
    bodies.push_back(
        &world_.Add(*shape.shape, 1,
                    MakeTransform(random.Rotation(), {std::fmod(place, 5) * 2 - 4, std::floor(place / 5) * 2 - 4, 1})));
    bodies.back()->setRollingFriction(btScalar(0.02));
    bodies.back()->setSpinningFriction(btScalar(0.02));
    shapes.push_back(&shape);
  }
  world_.Simulate(10);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    SCOPED_TRACE(shapes[i]->name);
    const btTransform& pose = bodies[i]->getWorldTransform();
    ASSERT_TRUE(IsFinite(pose));
    const double lowest = -PosedConvex{*shapes[i]->shape, pose}.SupportValue(-Vector::UnitZ());
    EXPECT_NEAR(lowest, 0, 0.004);
    EXPECT_LE(double(bodies[i]->getLinearVelocity().length()), 0.05);
    EXPECT_LE(double(bodies[i]->getAngularVelocity().length()), 0.2);
  }
  EXPECT_EQ(world_.statistics().Fallbacks(), 0U);
  for (btRigidBody* body : bodies) world_.world().removeRigidBody(body);
}

INSTANTIATE_TEST_SUITE_P(Routes, Simulation, testing::Values(Route::kConfiguration, Route::kRegister),
                         [](const testing::TestParamInfo<Route>& route) { return Name(route.param); });

/// Twenty bodies of all kinds fall into a heap; returns every transform of the last step as raw bytes.
std::vector<unsigned char> FinalTransforms(double seconds) {
  TestWorld world(Route::kConfiguration);
  world.AddGround();
  Random random(3);
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.5);
  std::vector<btRigidBody*> bodies;
  for (const ZooShape& shape : zoo) {
    if (shape.name == "Triangle" || shape.name == "MinkowskiSum") continue;
    const Eigen::Matrix3d rotation = random.Rotation();
    const Vector offset = 0.2 * random.InCube();
    const double height = 0.5 + 0.4 * static_cast<double>(bodies.size());
    bodies.push_back(&world.Add(*shape.shape, 1, MakeTransform(rotation, offset + Vector(0, 0, height))));
  }
  world.Simulate(seconds);
  std::vector<unsigned char> bytes;
  for (btRigidBody* body : bodies) {
    const btTransform& pose = body->getWorldTransform();
    EXPECT_TRUE(IsFinite(pose));
    for (const btVector3& vector : {pose.getOrigin(), pose.getBasis()[0], pose.getBasis()[1], pose.getBasis()[2]}) {
      std::array<btScalar, 3> values = {vector.x(), vector.y(), vector.z()};
      const std::size_t end = bytes.size();
      bytes.resize(end + sizeof(values));
      std::memcpy(bytes.data() + end, values.data(), sizeof(values));
    }
    world.world().removeRigidBody(body);
  }
  return bytes;
}

TEST(SimulationDeterminism, SameWorldTwice_SameBits) {
  const std::vector<unsigned char> first = FinalTransforms(2);
  EXPECT_FALSE(first.empty());
  // Something between the two, so that the second finds other addresses.
  const std::vector<std::vector<unsigned char>> ballast(100, std::vector<unsigned char>(1000));
  EXPECT_EQ(FinalTransforms(2), first);
}

/// The same experiment on Bullet's own narrowphase, on ours, and on ours without speculative contacts.
struct Experiment {
  const char* name;
  Route route;
  bool speculative;
};
constexpr Experiment kBuiltin = {"Builtin", Route::kBuiltin, false};

class BesideBuiltin : public testing::TestWithParam<Experiment> {
 protected:
  static std::unique_ptr<TestWorld> MakeWorld(const Experiment& experiment, const btVector3& gravity) {
    dgd_bullet::Options options;
    options.speculative_contacts = experiment.speculative;
    auto world = std::make_unique<TestWorld>(experiment.route, options);
    world->world().setGravity(gravity);
    return world;
  }

  /// Highest that a ball's lowest point gets between its first impact and its second, dropped from `height`.
  static double BounceHeight(const Experiment& experiment, double height, double restitution, double time_step) {
    const auto world = MakeWorld(experiment, Vec(0, 0, -9.81));
    world->AddGround().setRestitution(1);
    btRigidBody& ball = world->Add(world->Make<btSphereShape>(btScalar(0.2)), 1, Vec(0, 0, 0.2 + height));
    ball.setRestitution(btScalar(restitution));
    bool bounced = false;
    double highest = 0;
    for (int i = 0; i < static_cast<int>(20 / time_step); ++i) {
      world->world().stepSimulation(btScalar(time_step), 0);
      const double speed = double(ball.getLinearVelocity().z());
      bounced = bounced || speed > 0;
      if (bounced) highest = std::max(highest, double(ball.getWorldTransform().getOrigin().z()) - 0.2);
      if (bounced && speed < 0) break;
    }
    return highest;
  }
};

// As high as theory has it, whatever the time step; without speculation, at least as near to that as on the built-in.
TEST_P(BesideBuiltin, Ball_BouncesAsHigh) {
  for (const double time_step : {1.0 / 60, 1.0 / 240, 1.0 / 1000}) {
    for (const double height : {1.0, 2.0, 5.0}) {
      for (const double restitution : {0.5, 1.0}) {
        const double theory = restitution * restitution * height;
        const double ours = BounceHeight(GetParam(), height, restitution, time_step);
        const double bullets = BounceHeight(kBuiltin, height, restitution, time_step);
        // The highest of the places that it is seen at is lower than the apex by less than g dt^2 / 8.
        const double seen = 9.81 * time_step * time_step / 8;
        const double tolerance =
            GetParam().speculative ? 1e-3 * theory + seen : std::abs(bullets - theory) + 0.01 * theory;
        EXPECT_NEAR(ours, theory, tolerance)
            << height << " m, restitution " << restitution << ", " << 1 / time_step << " Hz; built-in " << bullets;
      }
    }
  }
}

// A body that flies past another without touching it flies on undisturbed.
TEST_P(BesideBuiltin, BodyFlyingPast_IsNotDeflected) {
  for (int phase = 0; phase < 10; ++phase) {
    for (const double speed : {5.0, 20.0, 60.0, 150.0}) {
      for (const double clearance : {0.03, 0.1, 0.3}) {
        for (const double half_length : {0.2, 2.0}) {
          const auto world = MakeWorld(GetParam(), Vec(0, 0, 0));
          world->Add(world->Make<btBoxShape>(Vec(half_length, 0.5, 0.5)), 0, Vec(0, 0, 0));
          const double x = -half_length - 3 - speed * TestWorld::kTimeStep * phase / 10;
          btRigidBody& ball = world->Add(world->Make<btSphereShape>(btScalar(0.2)), 1, Vec(x, 0, 0.7 + clearance));
          ball.setLinearVelocity(Vec(speed, 0, 0));
          world->Simulate(2 * (half_length + 3) / speed);
          EXPECT_LE(double((ball.getLinearVelocity() - Vec(speed, 0, 0)).length()), 1e-4 * speed)
              << speed << " m/s, phase " << phase << ", " << clearance << " m above a block of half length "
              << half_length;
        }
      }
    }
  }
}

// Nor does a blade touch that turns beside another body: its tips come no nearer than 10 cm.
TEST_P(BesideBuiltin, SpinningBodyNearAnother_IsNotSlowed) {
  const auto world = MakeWorld(GetParam(), Vec(0, 0, 0));
  world->Add(world->Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 0, Vec(0, 0, 0));
  btRigidBody& blade = world->Add(world->Make<btBoxShape>(Vec(0.6, 0.1, 0.1)), 1, Vec(1.21, 0, 0));
  blade.setAngularVelocity(Vec(0, 0, 30));
  world->Simulate(1);
  EXPECT_NEAR(double(blade.getAngularVelocity().z()), 30, 0.01);
  EXPECT_LE(double(blade.getLinearVelocity().length()), 1e-3);
}

// A fast small body is found deep inside a wall thicker than its step, and goes back the way it came.
TEST_P(BesideBuiltin, FastBody_IsStoppedByAThickWall) {
  for (int phase = 0; phase < 20; ++phase) {
    const auto world = MakeWorld(GetParam(), Vec(0, 0, 0));
    world->Add(world->Make<btBoxShape>(Vec(0.5, 2, 2)), 0, Vec(0, 0, 0));
    constexpr double kSpeed = 60;
    const double x = -2 - kSpeed * TestWorld::kTimeStep * phase / 20;
    btRigidBody& ball = world->Add(world->Make<btSphereShape>(btScalar(0.1)), 1, Vec(x, 0.1, 0.2));
    ball.setLinearVelocity(Vec(kSpeed, 0, 0));
    world->Simulate(0.5);
    EXPECT_LE(double(ball.getWorldTransform().getOrigin().x()), -0.59) << "phase " << phase;
  }
}

INSTANTIATE_TEST_SUITE_P(Experiments, BesideBuiltin,
                         testing::Values(kBuiltin, Experiment{"Default", Route::kConfiguration, true},
                                         Experiment{"WithoutSpeculation", Route::kConfiguration, false}),
                         [](const testing::TestParamInfo<Experiment>& experiment) {
                           return std::string(experiment.param.name);
                         });

}  // namespace
}  // namespace dgd_test
