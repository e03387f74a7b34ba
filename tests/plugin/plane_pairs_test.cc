// Convex shapes against static planes: every contact against Bullet's own support functions, and what lies on the
// ground.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "support/random.h"

namespace dgd_test {
namespace {

constexpr double kPlaneRoundoff = std::is_same_v<btScalar, float> ? 2e-6 : 1e-12;

/// A tilted plane away from its body's origin, and that body's pose.
class TiltedPlane {
 public:
  explicit TiltedPlane(Random& random)
      : pose_(MakeTransform(random.Rotation(), random.InCube())),
        shape_(ToBullet(random.UnitVector()), btScalar(random.Uniform(-1, 1))) {
    object_.setCollisionShape(&shape_);
    object_.setWorldTransform(pose_);
  }

  Vector Up() const { return ToEigen(pose_.getBasis() * shape_.getPlaneNormal()).normalized(); }
  double HeightOf(const Vector& point) const {
    return Up().dot(point - ToEigen(pose_.getOrigin())) - double(shape_.getPlaneConstant());
  }
  /// Of the shape's lowest point: of core and margin, but of boxes with sharp edges, as Bullet sees them against
  /// planes.
  double HeightOf(const btConvexShape& shape, const btTransform& pose) const {
    if (shape.getShapeType() != BOX_SHAPE_PROXYTYPE)
      return HeightOf(Vector(0, 0, 0)) - PosedConvex{shape, pose}.SupportValue(-Up());
    const btVector3 down = pose.getBasis().transpose() * ToBullet(-Up());
    return HeightOf(ToEigen(pose * shape.localGetSupportingVertex(down)));
  }
  /// A pose of the shape, turned at random, whose lowest point is at that height.
  btTransform PoseAt(double height, const btConvexShape& shape, Random& random) const {
    btTransform pose = MakeTransform(random.Rotation(), random.InCube());
    const double below = HeightOf(shape, pose) - height;
    pose.setOrigin(ToBullet(ToEigen(pose.getOrigin()) - below * Up()));
    return pose;
  }
  btCollisionObject& Object() { return object_; }

 private:
  btTransform pose_;
  btStaticPlaneShape shape_;
  btCollisionObject object_;
};

class CollectContacts : public btCollisionWorld::ContactResultCallback {
 public:
  /// @param convex  The body whose contacts are seen as A's.
  CollectContacts(const btCollisionObject& convex, double threshold) : convex_(convex) {
    m_closestDistanceThreshold = btScalar(threshold);
  }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* object_0, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    // Bullet's own algorithm has the convex body first, in either order of the call.
    EXPECT_EQ(object_0->getCollisionObject(), &convex_);
    contacts.push_back(
        {ToEigen(point.m_normalWorldOnB), ToEigen(point.getPositionWorldOnB()), double(point.getDistance())});
    return 0;
  }

  std::vector<Contact> contacts;

 private:
  const btCollisionObject& convex_;
};

class PlanePairs : public testing::TestWithParam<Route> {
 protected:
  std::vector<Contact> Ask(btCollisionObject& body_0, btCollisionObject& body_1, double threshold,
                           const btCollisionObject& convex) {
    CollectContacts collect(convex, threshold);
    world_.world().contactPairTest(&body_0, &body_1, collect);
    return collect.contacts;
  }

  TestWorld world_{GetParam(), Counting()};
};

// Of every convex type, in either order: apart, touching and deep.
TEST_P(PlanePairs, EveryType_DeepestContactIsTheLowestPointAndAllAreExact) {
  Random random(TestSeed());
  for (const ZooShape& zoo : MakeShapeZoo(1)) {
    SCOPED_TRACE(zoo.name);
    btCollisionObject body;
    body.setCollisionShape(zoo.shape.get());
    for (int i = 0; i < TestCount(20, 5) && !HasFailure(); ++i) {
      TiltedPlane plane(random);
      const double height = random.Uniform(-0.6, 0.4), threshold = 0.3;
      const btTransform pose = plane.PoseAt(height, *zoo.shape, random);
      body.setWorldTransform(pose);
      const double truth = plane.HeightOf(*zoo.shape, pose);
      for (const bool is_plane_first : {false, true}) {
        const std::vector<Contact> contacts =
            is_plane_first ? Ask(plane.Object(), body, threshold, body) : Ask(body, plane.Object(), threshold, body);
        if (contacts.empty()) {
          EXPECT_GT(truth, threshold);
          continue;
        }
        EXPECT_LE(truth, threshold + 0.05);  // And the breaking threshold.
        EXPECT_LE(contacts.size(), 4u);
        EXPECT_NEAR(Deepest(contacts).depth, truth, 4 * kPlaneRoundoff);
        for (const Contact& contact : contacts) {
          EXPECT_LT((contact.normal_b_to_a - plane.Up()).norm(), kPlaneRoundoff);
          EXPECT_NEAR(plane.HeightOf(contact.on_b), 0, 4 * kPlaneRoundoff);
          EXPECT_NEAR(plane.HeightOf(contact.OnA()), contact.depth, 4 * kPlaneRoundoff);
          // Of the shape. Boxes have sharp corners here, of which rounded ones fall short.
          const bool is_box = zoo.shape->getShapeType() == BOX_SHAPE_PROXYTYPE;
          const double corner = is_box ? (std::sqrt(3) - 1) * PosedConvex{*zoo.shape, pose}.Margin() : 0;
          EXPECT_LT(Outside({*zoo.shape, pose}, contact.OnA()), corner + 1e-5);
        }
      }
    }
  }
  EXPECT_EQ(world_.statistics().Fallbacks(), 0u);
}

// What Bullet makes of it is no normal: there are no contacts, and that is counted.
TEST_P(PlanePairs, PlaneWithoutNormal_HasNoContacts) {
  btStaticPlaneShape plane(Vec(0, 0, 0), 0);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  btCollisionObject body, ground;
  body.setCollisionShape(&box);
  ground.setCollisionShape(&plane);
  EXPECT_TRUE(Ask(body, ground, 1, body).empty());
  EXPECT_EQ(world_.statistics().fallbacks_invalid, 1u);
}

TEST_P(PlanePairs, BoxAtRest_KeepsItsContactsUntilThePlaneIsAnother) {
  btStaticPlaneShape plane(Vec(0, 0, 1), 0), raised(Vec(0, 0, 1), btScalar(0.001)), tilted(Vec(0.01, 0, 1), 0);
  btBoxShape box(Vec(0.5, 0.4, 0.3));
  btRigidBody& ground = world_.Add(plane, 0, At(0, 0, 0));
  btRigidBody& body = world_.Add(box, 1, At(0, 0, 0.3));
  body.setActivationState(DISABLE_DEACTIVATION);
  world_.Simulate(0.1);
  const auto resting = [&] { return world_.statistics().pairs.at(0).resting; };
  const auto rested = resting();
  EXPECT_GT(rested, 10u);
  ASSERT_EQ(world_.Points().size(), 4u);

  ground.setCollisionShape(&raised);
  world_.Detect();
  EXPECT_EQ(resting(), rested);
  for (const btManifoldPoint& point : world_.Points()) EXPECT_NEAR(double(point.getDistance()), -0.001, 1e-5);

  ground.setCollisionShape(&tilted);
  world_.Detect();
  EXPECT_EQ(resting(), rested);
  for (const btManifoldPoint& point : world_.Points()) {
    EXPECT_NEAR(double(point.m_normalWorldOnB.dot(tilted.getPlaneNormal())), 1, 1e-6);
  }

  ground.setCollisionShape(&plane);
  ground.setWorldTransform(At(0, 0, -0.1));
  world_.Detect();
  EXPECT_TRUE(world_.Points().empty());
}

// Each child stands where its own transform puts it.
TEST_P(PlanePairs, CompoundOnPlane_StandsOnItsChildren) {
  btStaticPlaneShape plane(Vec(0, 0, 1), 0);
  btBoxShape leg(Vec(0.1, 0.1, 0.5));
  btCompoundShape table;
  for (const double x : {-1.0, 1.0}) table.addChildShape(At(x, 0, 0), &leg);
  world_.Add(plane, 0, At(0, 0, 0));
  btRigidBody& body = world_.Add(table, 1, At(0, 0, 0.51));
  body.setActivationState(DISABLE_DEACTIVATION);
  world_.Simulate(1);
  EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), 0.5, 1e-4);
  EXPECT_EQ(world_.Points().size(), 8u);
}

INSTANTIATE_TEST_SUITE_P(Routes, PlanePairs, testing::Values(Route::kConfiguration, Route::kRegister),
                         [](const auto& route) { return Name(route.param); });

/// Of bodies that fall onto a plane, the depth of each one's lowest point at its worst, on average; metres.
double DeepestLanding(Route route) {
  constexpr int kBodies = 30;
  TestWorld world(route);
  world.Add(world.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0)), 0, At(0, 0, 0));
  Random random(TestSeed());
  std::vector<btRigidBody*> bodies;
  for (int i = 0; i < kBodies; ++i) {
    btConvexShape& shape = i % 3 == 0   ? static_cast<btConvexShape&>(world.Keep(MakeRandomHull(random, 12, 1)))
                           : i % 3 == 1 ? static_cast<btConvexShape&>(world.Make<btBoxShape>(Vec(0.3, 0.4, 0.5)))
                                        : world.Make<btCylinderShapeZ>(Vec(0.4, 0.4, 0.3));
    bodies.push_back(&world.Add(shape, 1, MakeTransform(random.Rotation(), {2.0 * (i % 6), 2.0 * (i / 6), 1.5})));
  }
  std::vector<double> deepest(bodies.size(), 0);
  for (int k = 0; k < 480; ++k) {
    world.Simulate(TestWorld::kTimeStep);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const btTransform& pose = bodies[i]->getWorldTransform();
      const auto& shape = *static_cast<const btConvexShape*>(bodies[i]->getCollisionShape());
      const btVector3 lowest = pose * shape.localGetSupportingVertex(pose.getBasis().transpose() * Vec(0, 0, -1));
      deepest[i] = std::max(deepest[i], -double(lowest.z()));
    }
  }
  return std::accumulate(deepest.begin(), deepest.end(), 0.0) / kBodies;
}

// The first corner is met ahead. One that comes down next to another counts once it has landed, as true rolling and
// rocking want it, and is up to a step's way deep by then.
TEST(PlaneLanding, Bodies_SinkInLessDeepThanOnTheBuiltin) {
  const double builtin = DeepestLanding(Route::kBuiltin), ours = DeepestLanding(Route::kConfiguration);
  std::printf("deepest while landing, mean of bodies: built-in %.3f mm, ours %.3f mm\n", 1e3 * builtin, 1e3 * ours);
  EXPECT_LT(ours, 0.7 * builtin);
}

// What comes down beside the line that a cylinder rolls on only touches, and is no rim: held early, it would brake.
TEST(RollingCylinder, KeepsItsSpeed) {
  btCylinderShapeZ cylinder(Vec(0.4, 0.4, 0.3));
  const Eigen::Matrix3d on_its_side = Eigen::AngleAxisd(std::numbers::pi / 2, Vector::UnitX()).toRotationMatrix();
  for (const bool on_plane : {false, true}) {
    TestWorld world(Route::kConfiguration);
    if (on_plane) {
      world.Add(world.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0)), 0, At(0, 0, 0));
    } else {
      world.AddGround(20);
    }
    btRigidBody& body = world.Add(cylinder, 1, MakeTransform(on_its_side, {0, 0, 0.4}));
    body.setAngularVelocity(Vec(0, 5, 0));
    body.setLinearVelocity(Vec(2, 0, 0));
    for (int i = 0; i < 180; ++i) world.world().stepSimulation(btScalar(1) / 60, 0, btScalar(1) / 60);
    EXPECT_NEAR(double(body.getAngularVelocity().y()), 5, 0.01) << on_plane;
    EXPECT_NEAR(double(body.getLinearVelocity().x()), 2, 0.01) << on_plane;
  }
}

}  // namespace
}  // namespace dgd_test
