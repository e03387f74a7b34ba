// What Bullet tells an app of contacts, and keeps for it with them, beside the built-in: in every step, of each point,
// whether that is new or goes on.
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <gtest/gtest.h>

#include <vector>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

struct Told {
  int added = 0, processed = 0, destroyed = 0, started = 0, ended = 0;

  friend bool operator==(const Told&, const Told&) = default;
};

Told told;

bool Added(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_0, int, int,
           const btCollisionObjectWrapper* wrapper_1, int, int) {
  ++told.added;
  EXPECT_NE(wrapper_0->getCollisionObject(), wrapper_1->getCollisionObject());
  // As apps do that have friction of their own.
  point.m_combinedFriction = btScalar(0.125);
  return true;
}
bool Processed(btManifoldPoint&, void* body_0, void* body_1) {
  ++told.processed;
  EXPECT_NE(body_0, body_1);
  return true;
}
bool Destroyed(void*) {
  ++told.destroyed;
  return true;
}
void Started(btPersistentManifold* const&) { ++told.started; }
void Ended(btPersistentManifold* const&) { ++told.ended; }

class ContactCallbacks : public testing::TestWithParam<Route> {
 protected:
  ContactCallbacks() {
    told = {};
    gContactAddedCallback = Added;
    gContactProcessedCallback = Processed;
    gContactDestroyedCallback = Destroyed;
    gContactStartedCallback = Started;
    gContactEndedCallback = Ended;
  }
  ~ContactCallbacks() override {
    gContactAddedCallback = nullptr;
    gContactProcessedCallback = nullptr;
    gContactDestroyedCallback = nullptr;
    gContactStartedCallback = nullptr;
    gContactEndedCallback = nullptr;
  }

  static dgd_bullet::Options WithoutRest() {
    dgd_bullet::Options options;
    options.keep_resting_contacts = false;
    return options;
  }

  static void Place(btRigidBody& body, double x, double z) { body.getWorldTransform().setOrigin(Vec(x, 0, z)); }
};

TEST_P(ContactCallbacks, BoxThatLandsSlidesAndLeaves_IsToldOfAsByTheBuiltin) {
  TestWorld world(GetParam(), WithoutRest());
  world.AddGround();
  btRigidBody& body = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 1));
  body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  world.Detect();
  EXPECT_EQ(told, Told());
  constexpr int kSteps = 5;
  for (int step = 0; step < kSteps; ++step) {
    Place(body, 0.001 * step, 0.499);
    world.Detect();
    ASSERT_EQ(world.Points().size(), 4U);
    for (const btManifoldPoint& point : world.Points()) {
      EXPECT_EQ(point.m_combinedFriction, btScalar(0.125));
      EXPECT_EQ(point.getLifeTime(), step + 1);
    }
  }
  EXPECT_EQ(told, (Told{.added = 4 * kSteps, .processed = 4 * kSteps, .started = 1}));
  Place(body, 0, 2);
  world.Detect();
  EXPECT_EQ(told.ended, 1);
}

/// Of which Bullet's refresh makes what the point's places say.
bool FarAway(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
             int) {
  point.m_distance1 = 1000;
  return true;
}

TEST_P(ContactCallbacks, DistanceThatACallbackSets_HasNoEffect) {
  gContactAddedCallback = FarAway;
  TestWorld world(GetParam());
  world.AddGround();
  btRigidBody& body = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.499));
  body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  world.Detect();
  ASSERT_EQ(world.Points().size(), 4U);
  for (const btManifoldPoint& point : world.Points()) EXPECT_NEAR(double(point.getDistance()), -0.001, 1e-5);
}

TEST_P(ContactCallbacks, WhatTheAppKeepsWithAPoint_StaysWithItAndIsGivenBack) {
  TestWorld world(GetParam(), WithoutRest());
  world.AddGround();
  btRigidBody& body = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.499));
  world.Detect();
  btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(0);
  ASSERT_EQ(manifold.getNumContacts(), 4);
  std::vector<int> owned(4);
  for (std::size_t i = 0; i < owned.size(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(static_cast<int>(i));
    point.m_userPersistentData = &owned[i];
    point.m_contactMotion1 = 1;
    point.m_appliedImpulse = btScalar(i + 1);
  }
  Place(body, 0.001, 0.499);
  world.Detect();
  ASSERT_EQ(manifold.getNumContacts(), 4);
  for (int i = 0; i < 4; ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    ASSERT_NE(point.m_userPersistentData, nullptr);
    // Wherever in the manifold, with the impulse that it had.
    const auto which = static_cast<int*>(point.m_userPersistentData) - owned.data();
    EXPECT_EQ(point.m_appliedImpulse, btScalar(which + 1));
    EXPECT_EQ(point.m_contactMotion1, btScalar(0)) << "of the point as it was";
  }
  EXPECT_EQ(told.destroyed, 0);
  Place(body, 0, 2);
  world.Detect();
  EXPECT_EQ(told.destroyed, 4);
}

TEST_P(ContactCallbacks, StiffnessOfABody_IsItsContactsInEveryStep) {
  TestWorld world(GetParam(), WithoutRest());
  world.AddGround();
  btRigidBody& body = world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.499));
  body.setContactStiffnessAndDamping(btScalar(300), btScalar(10));
  for (int step = 0; step < 3; ++step) {
    Place(body, 0.001 * step, 0.499);
    world.Detect();
    ASSERT_EQ(world.Points().size(), 4U);
    for (const btManifoldPoint& point : world.Points()) {
      EXPECT_NE(point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING, 0) << step;
      EXPECT_NEAR(double(point.m_combinedContactStiffness1), 300, 1) << step;
      EXPECT_NEAR(double(point.m_combinedContactDamping1), 10.1, 0.2) << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Narrowphases, ContactCallbacks, testing::Values(Route::kBuiltin, Route::kConfiguration),
                         [](const auto& route) { return route.param == Route::kBuiltin ? "Builtin" : "Ours"; });

}  // namespace
}  // namespace dgd_test
