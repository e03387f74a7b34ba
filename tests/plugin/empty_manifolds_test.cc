// Pairs that do not touch and have no manifold: what an app or Bullet could see of it, and must not.
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <vector>

#include "plugin/pair_query.h"
#include "plugin/test_world.h"
#include "support/random.h"

namespace dgd_test {
namespace {

const btTransform kTouchingPose = MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.99});
const btTransform kFarPose = MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 5});

dgd_bullet::Options Keeping(bool empty_manifolds) {
  dgd_bullet::Options options;
  options.keep_empty_manifolds = empty_manifolds;
  return options;
}

/// Has no manifold to give while `exhausted`, as one whose pool is full and may not grow.
class PoorDispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override {
    return exhausted ? nullptr : btCollisionDispatcher::getNewManifold(a, b);
  }
  bool exhausted = false;
};

class Pair {
 public:
  explicit Pair(const dgd_bullet::Options& options) : configuration_(options) {}

  /// @return how many contacts there are.
  std::size_t StepAt(const btTransform& pose) {
    query_.SetPoses(pose, btTransform::getIdentity());
    return query_.Step().size();
  }
  PairQuery& query() { return query_; }
  PoorDispatcher& dispatcher() { return dispatcher_; }
  int Manifolds() { return dispatcher_.getNumManifolds(); }
  dgd_bullet::Statistics statistics() const { return configuration_.statistics(); }

 private:
  dgd_bullet::CollisionConfiguration configuration_;
  PoorDispatcher dispatcher_{&configuration_};
  btBoxShape box_{Vec(0.5, 0.5, 0.5)};
  PairQuery query_{dispatcher_, box_, box_};
};

TEST(EmptyManifolds, OnAPlane_GivenBackAsWell) {
  for (const bool keeps : {true, false}) {
    TestWorld world(Route::kConfiguration, Keeping(keeps));
    world.Add(world.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0)), 0, btTransform::getIdentity());
    btRigidBody& box = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, kFarPose);
    box.setActivationState(DISABLE_DEACTIVATION);
    const auto manifolds = [&] { return world.world().getDispatcher()->getNumManifolds(); };
    world.Simulate(TestWorld::kTimeStep);
    EXPECT_EQ(manifolds(), 1) << "each pair begins with one, as Bullet's does";
    world.Simulate(TestWorld::kTimeStep);
    EXPECT_EQ(manifolds(), keeps ? 1 : 0);
    world.Simulate(2.5);
    ASSERT_EQ(manifolds(), 1) << "on the plane";
    EXPECT_EQ(world.world().getDispatcher()->getManifoldByIndexInternal(0)->getNumContacts(), 4);
    EXPECT_NEAR(double(box.getWorldTransform().getOrigin().z()), 0.5, 1e-3);
  }
}

TEST(EmptyManifolds, GivenBack_ComeBackWithContacts) {
  Pair pair(Keeping(false));
  pair.StepAt(kFarPose);
  EXPECT_EQ(pair.Manifolds(), 1) << "each pair begins with one, as Bullet's does";
  pair.StepAt(kFarPose);
  EXPECT_EQ(pair.Manifolds(), 0);
  EXPECT_EQ(pair.query().manifold(), nullptr);

  EXPECT_EQ(pair.StepAt(kTouchingPose), 4U);
  ASSERT_EQ(pair.Manifolds(), 1);
  EXPECT_EQ(pair.query().manifold()->getBody0(), &pair.query().body_a());
  EXPECT_EQ(pair.query().manifold()->getNumContacts(), 4);
  pair.StepAt(kTouchingPose);
  EXPECT_EQ(pair.Manifolds(), 1);

  pair.StepAt(kFarPose);
  ASSERT_EQ(pair.Manifolds(), 1) << "bodies that part may touch again at once";
  EXPECT_EQ(pair.query().manifold()->getNumContacts(), 0);
  pair.StepAt(kFarPose);
  EXPECT_EQ(pair.Manifolds(), 0);
}

TEST(EmptyManifolds, Kept_AreThePairsOwnToItsEnd) {
  Pair pair({});
  pair.StepAt(kFarPose);
  const btPersistentManifold* manifold = pair.query().manifold();
  ASSERT_NE(manifold, nullptr);
  for (const btTransform& pose : {kFarPose, kTouchingPose, kFarPose, kFarPose}) {
    pair.StepAt(pose);
    EXPECT_EQ(pair.query().manifold(), manifold);
  }
}

// Whose manifolds' order is part of the state.
TEST(EmptyManifolds, WithoutWarmStart_AreKept) {
  dgd_bullet::Options options = Keeping(false);
  options.warm_start = false;
  Pair pair(options);
  for (int step = 0; step < 3; ++step) pair.StepAt(kFarPose);
  EXPECT_EQ(pair.Manifolds(), 1);
}

// Contacts begin at the manifold's breaking threshold, also while there is no manifold: a relative one in small bodies.
TEST(EmptyManifolds, GivenBack_ContactsBeginAtTheSameDistance) {
  constexpr int kRelative = btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD;
  btBoxShape small(Vec(0.05, 0.05, 0.05));
  const auto has_contacts = [&](bool keep, bool is_relative, double gap) {
    dgd_bullet::CollisionConfiguration configuration(Keeping(keep));
    btCollisionDispatcher dispatcher(&configuration);
    const int flags = dispatcher.getDispatcherFlags();
    dispatcher.setDispatcherFlags(is_relative ? flags | kRelative : flags & ~kRelative);
    PairQuery query(dispatcher, small, small);
    query.SetPoses(kFarPose, btTransform::getIdentity());
    for (int step = 0; step < 2; ++step) query.Step();
    query.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.1 + gap}), btTransform::getIdentity());
    return !query.Step().empty();
  };
  for (const bool is_relative : {false, true}) {
    const btScalar threshold =
        is_relative ? small.getContactBreakingThreshold(gContactBreakingThreshold) : gContactBreakingThreshold;
    for (const bool keep : {true, false}) {
      EXPECT_TRUE(has_contacts(keep, is_relative, 0.95 * double(threshold))) << keep << is_relative;
      EXPECT_FALSE(has_contacts(keep, is_relative, 1.05 * double(threshold))) << keep << is_relative;
    }
  }
}

// As every result of Bullet's has: apps look into it without asking.
TEST(EmptyManifolds, Result_HasAnEmptyOneAllTheSame) {
  Pair pair(Keeping(false));
  for (int step = 0; step < 2; ++step) pair.StepAt(kFarPose);
  btCollisionObject &a = pair.query().body_a(), &b = pair.query().body_b();
  const btCollisionObjectWrapper wrapper_a(nullptr, a.getCollisionShape(), &a, a.getWorldTransform(), -1, -1);
  const btCollisionObjectWrapper wrapper_b(nullptr, b.getCollisionShape(), &b, b.getWorldTransform(), -1, -1);
  for (int call = 0; call < 2; ++call) {
    btManifoldResult result(&wrapper_a, &wrapper_b);
    pair.query().algorithm()->processCollision(&wrapper_a, &wrapper_b, btDispatcherInfo(), &result);
    btPersistentManifold* manifold = result.getPersistentManifold();
    ASSERT_NE(manifold, nullptr);
    EXPECT_EQ(manifold->getBody0(), &a);
    EXPECT_EQ(manifold->getBody1(), &b);
    EXPECT_GT(manifold->getContactBreakingThreshold(), 0);
    EXPECT_EQ(manifold->getNumContacts(), 0);
    // What an app adds is nobody's in the next call.
    result.addContactPoint(Vec(0, 0, 1), Vec(0, 0, 0), 0);
    EXPECT_EQ(manifold->getNumContacts(), 1);
  }
  EXPECT_EQ(pair.Manifolds(), 0);
}

TEST(EmptyManifolds, NoneLeftWhenBodiesTouch_IsCountedAndTriedAgain) {
  Pair pair(Keeping(false));
  for (int step = 0; step < 2; ++step) pair.StepAt(kFarPose);
  pair.dispatcher().exhausted = true;
  for (int step = 0; step < 2; ++step) EXPECT_EQ(pair.StepAt(kTouchingPose), 0U);
  EXPECT_EQ(pair.statistics().fallbacks_no_memory, 2U);
  pair.dispatcher().exhausted = false;
  EXPECT_EQ(pair.StepAt(kTouchingPose), 4U);
}

// Bullet wakes what shares a manifold with a kinematic body, if an empty one.
TEST(EmptyManifolds, KinematicBody_WakesItsNeighboursAsWithBullet) {
  for (const Route route : {Route::kBuiltin, Route::kConfiguration}) {
    const int without = route == Route::kBuiltin ? 1 : 0;
    TestWorld world(route, Keeping(false));
    auto& sphere = world.Make<btSphereShape>(btScalar(0.5));
    world.world().setGravity(Vec(0, 0, 0));
    // Their bounding boxes overlap, and they do not touch.
    btRigidBody& sleeper = world.Add(sphere, 1, Vec(0, 0, 0));
    btRigidBody& mover = world.Add(sphere, 1, Vec(0.8, 0.8, 0));
    world.Simulate(3 * TestWorld::kTimeStep);
    EXPECT_EQ(world.dispatcher().getNumManifolds(), without) << Name(route);
    sleeper.forceActivationState(ISLAND_SLEEPING);
    mover.setCollisionFlags(mover.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    mover.forceActivationState(DISABLE_DEACTIVATION);
    world.Simulate(3 * TestWorld::kTimeStep);
    EXPECT_TRUE(sleeper.isActive()) << Name(route);
    EXPECT_EQ(world.dispatcher().getNumManifolds(), 1) << Name(route);
    // No longer.
    mover.setCollisionFlags(mover.getCollisionFlags() & ~btCollisionObject::CF_KINEMATIC_OBJECT);
    world.Simulate(3 * TestWorld::kTimeStep);
    EXPECT_EQ(world.dispatcher().getNumManifolds(), without) << Name(route);
  }
}

// Bullet's dispatcher with threads lists new manifolds after a step, and may release none that is not listed.
TEST(EmptyManifolds, MadeForBulletsOwnAnswer_IsNotGivenBackInTheSameStep) {
  dgd_bullet::Options options = Keeping(false);
  options.on_first_fallback = nullptr;
  options.max_iterations = 1;
  dgd_bullet::CollisionConfiguration configuration(options);
  btCollisionDispatcher dispatcher(&configuration);
  // Both flat, and in one evaluation left to GJK/EPA.
  btTriangleShape triangle(Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0));
  triangle.setMargin(0);
  PairQuery query(dispatcher, triangle, triangle);
  query.SetPoses(kFarPose, btTransform::getIdentity());
  for (const int manifolds : {1, 0, 1, 0}) {
    query.Step();
    EXPECT_EQ(dispatcher.getNumManifolds(), manifolds);
  }
  EXPECT_EQ(configuration.statistics().fallbacks_no_interior, 4U);
}

// Two bodies that meet and part: whether they have a manifold meanwhile is nothing that they could tell.
TEST(EmptyManifolds, GivenBack_BodiesMoveToTheSameBits) {
  const auto run = [](bool keep) {
    TestWorld world(Route::kConfiguration, Keeping(keep));
    auto& box = world.Make<btBoxShape>(Vec(0.5, 0.3, 0.2));
    world.AddGround().setRestitution(1);
    btRigidBody& body = world.Add(box, 1, MakeTransform(Random(3).Rotation(), {0, 0, 1}));
    body.setRestitution(btScalar(0.5));
    int steps_with = 0, steps_without = 0;
    for (int step = 0; step < 720; ++step) {
      world.Simulate(TestWorld::kTimeStep);
      const bool are_near = world.world().getPairCache()->getNumOverlappingPairs() > 0;
      (world.dispatcher().getNumManifolds() > 0 ? steps_with : steps_without) += are_near;
    }
    EXPECT_GT(steps_with, 10);
    EXPECT_EQ(steps_without > 10, !keep);
    return body.getWorldTransform();
  };
  EXPECT_EQ(run(true), run(false));
}

}  // namespace
}  // namespace dgd_test
