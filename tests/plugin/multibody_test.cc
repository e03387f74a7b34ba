// What links of multibodies do: they rebound, and what their joints hold up touches nothing.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "plugin/rigid_body.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr double kGravity = 9.81, kHalf = 0.25;  // m/s^2, m

/// A world on our narrowphase with a ground whose top is at 0, and a multibody in it; z is up.
class MultibodyWorld {
 public:
  MultibodyWorld(btCollisionShape& ground, double ground_height, double restitution)
      : ground_(MakeRigidBody(ground, 0, At(ground_height))) {
    world_.setGravity(Vec(0, 0, -kGravity));
    ground_->setRestitution(btScalar(restitution));
    world_.addRigidBody(ground_.get());
  }
  ~MultibodyWorld() {
    for (const auto& link : links_) world_.removeCollisionObject(link.get());
    if (body_ != nullptr) world_.removeMultiBody(body_);
    world_.removeRigidBody(ground_.get());
  }
  MultibodyWorld(const MultibodyWorld&) = delete;
  MultibodyWorld& operator=(const MultibodyWorld&) = delete;

  /// @param body  Outlives this world.
  void Add(btMultiBody& body) {
    body_ = &body;
    world_.addMultiBody(&body);
  }
  void AddCollider(int link, btCollisionShape& shape, const btVector3& place) {
    links_.push_back(std::make_unique<btMultiBodyLinkCollider>(body_, link));
    btMultiBodyLinkCollider& collider = *links_.back();
    collider.setCollisionShape(&shape);
    collider.setRestitution(1);
    collider.setWorldTransform(btTransform(btQuaternion::getIdentity(), place));
    (link < 0 ? body_->setBaseCollider(&collider) : void(body_->getLink(link).m_collider = &collider));
    world_.addCollisionObject(&collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
  btMultiBodyDynamicsWorld& world() { return world_; }
  /// Points that show an overlap, as apps ask for touches.
  int Touches() {
    int touches = 0;
    btDispatcher& dispatcher = dispatching_.dispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
      for (int j = 0; j < manifold.getNumContacts(); ++j) touches += manifold.getContactPoint(j).getDistance() < 0;
    }
    return touches;
  }

 private:
  static btTransform At(double height) { return btTransform(btQuaternion::getIdentity(), Vec(0, 0, height)); }

  Dispatching dispatching_{Route::kConfiguration};
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_{&dispatching_.dispatcher(), &broadphase_, &solver_, &dispatching_.configuration()};
  std::unique_ptr<btRigidBody> ground_;
  btMultiBody* body_ = nullptr;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> links_;
};

/// A body of one shape, alone or with the same on top by a fixed joint, that falls onto a ground.
struct Fall {
  btConvexShape& shape;
  btCollisionShape& ground;
  double ground_height, restitution, rate;
  int links;
};

/// Calls see(const btMultiBody&) after each step.
/// @param drop  m.
template <class See>
void LetFall(const Fall& fall, double drop, double seconds, const See& see) {
  btVector3 inertia;
  fall.shape.calculateLocalInertia(1, inertia);
  btMultiBody body(fall.links, 1, inertia, /*fixedBase=*/false, /*canSleep=*/false);
  const btVector3 apart = Vec(0, 0, 2.2 * kHalf), none = Vec(0, 0, 0);
  for (int link = 0; link < fall.links; ++link) {
    body.setupFixed(link, 1, inertia, link - 1, btQuaternion::getIdentity(), apart, none);
  }
  body.finalizeMultiDof();
  body.setLinearDamping(0);
  body.setBasePos(Vec(0, 0, kHalf + drop));
  MultibodyWorld world(fall.ground, fall.ground_height, fall.restitution);
  world.Add(body);
  for (int link = -1; link < fall.links; ++link) {
    world.AddCollider(link, fall.shape, body.getBasePos() + btScalar(link + 1) * apart);
  }
  for (int step = 0; step < int(seconds * fall.rate); ++step) {
    world.world().stepSimulation(btScalar(1 / fall.rate), 0);
    see(body);
  }
}

/// The root of the part that an impact leaves of a fall's energy: the coefficient of restitution.
double Rebound(const Fall& fall) {
  constexpr double kDrop = 0.7513;  // m
  double rebound = 0;
  LetFall(fall, kDrop, 1, [&](const btMultiBody& body) {
    // Through the places of the steps, Bullet's flight is a parabola that is slower by half a step's fall.
    const double speed = double(body.getBaseVel().z()) - kGravity / fall.rate / 2;
    const double height = double(body.getBasePos().z()) - kHalf;
    if (!(speed > 0) || rebound > 0) return;
    rebound = std::sqrt((speed * speed / 2 + kGravity * height) / (kGravity * kDrop));
  });
  return rebound;
}

class MultibodyOnGrounds : public testing::TestWithParam<int> {
 protected:
  /// Of a sphere and a box on a plane and a box.
  std::vector<Fall> Falls(double restitution, double rate) {
    std::vector<Fall> falls;
    for (btConvexShape* shape : {static_cast<btConvexShape*>(&sphere_), static_cast<btConvexShape*>(&box_)}) {
      falls.push_back({*shape, plane_, 0, restitution, rate, GetParam()});
      falls.push_back({*shape, slab_, -1, restitution, rate, GetParam()});
    }
    return falls;
  }

  btSphereShape sphere_{btScalar(kHalf)};
  btBoxShape box_{Vec(kHalf, kHalf, kHalf)}, slab_{Vec(5, 5, 1)};
  btStaticPlaneShape plane_{Vec(0, 0, 1), 0};
};

INSTANTIATE_TEST_SUITE_P(Links, MultibodyOnGrounds, testing::Values(0, 1));

// Bullet's own narrowphase: 0.35 to 1.35 at 60 Hz, 0 to 1.01 at 1000 Hz.
TEST_P(MultibodyOnGrounds, ReboundIsThatOfTheRestitution) {
  constexpr double kTolerance = 0.005;
  for (const double rate : {60.0, 240.0, 1000.0}) {
    for (const double restitution : {0.5, 1.0}) {
      for (const Fall& fall : Falls(restitution, rate)) {
        EXPECT_NEAR(Rebound(fall), restitution, kTolerance)
            << fall.shape.getName() << " on " << fall.ground.getName() << " at " << rate << " Hz";
      }
    }
  }
}

TEST_P(MultibodyOnGrounds, ElasticBody_ComesToRest) {
  constexpr double kTime = 12;  // s
  for (const double rate : {60.0, 240.0}) {
    for (const Fall& fall : Falls(0.5, rate)) {
      double time = 0, fastest = 0;
      LetFall(fall, 0.3, kTime, [&](const btMultiBody& body) {
        time += 1 / rate;
        if (time > kTime - 1) fastest = std::max(fastest, double(body.getBaseVel().length()));
      });
      EXPECT_LT(fastest, 1e-3) << fall.shape.getName() << " on " << fall.ground.getName() << " at " << rate << " Hz";
    }
  }
}

// Within a step of 1/60 s, it would fall by 2.7 mm.
TEST(Multibody, LinkThatItsMotorHoldsJustAboveTheGround_TouchesNothing) {
  btBoxShape box(Vec(kHalf, kHalf, kHalf)), slab(Vec(5, 5, 1));
  btMultiBody body(1, 1, Vec(1, 1, 1), /*fixedBase=*/true, /*canSleep=*/false);
  const btVector3 none = Vec(0, 0, 0), place = Vec(0, 0, kHalf + 0.002);
  body.setupPrismatic(0, 1, Vec(1, 1, 1), -1, btQuaternion::getIdentity(), Vec(0, 0, 1), none, none, true);
  body.setBasePos(place);
  body.finalizeMultiDof();
  MultibodyWorld world(slab, -1, 0);
  world.Add(body);
  world.AddCollider(0, box, place);
  btMultiBodyJointMotor motor(&body, 0, 0, btScalar(1000));
  world.world().addMultiBodyConstraint(&motor);
  for (int step = 0; step < 30; ++step) {
    world.world().stepSimulation(btScalar(1.0 / 60), 0);
    EXPECT_EQ(world.Touches(), 0) << "step " << step;
  }
  EXPECT_NEAR(double(body.getJointPos(0)), 0, 1e-6);
  world.world().removeMultiBodyConstraint(&motor);
}

}  // namespace
}  // namespace dgd_test
