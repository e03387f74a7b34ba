// dgd_bullet::CollisionDispatcher against btCollisionDispatcher: the same worlds and lists of manifolds to the last
// bit, for any number of threads, whatever an app does to its bodies.
#include "dgd_bullet/collision_dispatcher.h"

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <LinearMath/btIDebugDraw.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "plugin/crowd.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

using dgd_bullet::DispatcherOptions;

constexpr DispatcherOptions Threads(int threads) { return {.threads = threads}; }

constexpr int kSteps = 150;

/// The dispatcher with each number of threads, all against one run of btCollisionDispatcher.
void ExpectSameWorlds(const std::vector<int>& thread_counts, const dgd_bullet::Options& options) {
  Crowd expected(std::nullopt, options);
  std::vector<std::unique_ptr<Crowd>> crowds;
  for (const int threads : thread_counts) crowds.push_back(std::make_unique<Crowd>(Threads(threads), options));
  std::size_t numbers = 0;
  for (int step = 0; step < kSteps; ++step) {
    expected.Step();
    const State state = expected.Read();
    numbers = state.size();
    for (std::size_t i = 0; i < crowds.size(); ++i) {
      crowds[i]->Step();
      ASSERT_EQ(crowds[i]->Read(), state) << "step " << step << ", " << thread_counts[i] << " threads";
    }
  }
  EXPECT_GT(numbers, std::size_t{5000});
  for (const auto& crowd : crowds) {
    EXPECT_EQ(dgd_bullet::ToJson(crowd->world().statistics()), dgd_bullet::ToJson(expected.world().statistics()));
  }
}

TEST(CollisionDispatcher, AnyNumberOfThreads_GivesTheWorldOfBulletsDispatcher) { ExpectSameWorlds({1, 2, 3}, {}); }

TEST(CollisionDispatcher, CountedPairs_HaveTheStatisticsOfBulletsDispatcher) { ExpectSameWorlds({2}, Counting()); }

TEST(CollisionDispatcher, WithoutEmptyManifolds_ListsManifoldsInBulletsOrder) {
  dgd_bullet::Options options;
  options.keep_empty_manifolds = false;
  ExpectSameWorlds({1, 3}, options);
}

TEST(CollisionDispatcher, OrderedPairs_AreSolvedInThatOrder) {
  Crowd expected(std::nullopt), crowd(Threads(2));
  for (Crowd* each : {&expected, &crowd})
    each->world().world().getDispatchInfo().m_deterministicOverlappingPairs = true;
  for (int step = 0; step < 50; ++step) {
    expected.Step();
    crowd.Step();
    ASSERT_EQ(crowd.Read(), expected.Read()) << "step " << step;
  }
}

/// Counts the pairs whose near callback is called.
class VisitCounter : public dgd_bullet::CollisionDispatcher {
 public:
  using CollisionDispatcher::CollisionDispatcher;
  bool needsCollision(const btCollisionObject* body_0, const btCollisionObject* body_1) override {
    ++visits;
    return CollisionDispatcher::needsCollision(body_0, body_1);
  }
  int visits = 0;
};

/// Two round hulls across a gap of some centimetres: their bounding boxes overlap.
class TwoHulls {
 public:
  explicit TwoHulls(const dgd_bullet::Options& options = {}) : configuration_(options) {
    world_.setGravity(Vec(0, 0, 0));
    for (const auto& body : {std::ref(a_), std::ref(b_)}) {
      body.get()->setActivationState(DISABLE_DEACTIVATION);
      world_.addRigidBody(body.get().get());
    }
  }
  ~TwoHulls() {
    for (btRigidBody* body : {a_.get(), b_.get()}) world_.removeRigidBody(body);
  }

  /// @return how many contacts there are after a step.
  int Step() {
    dispatcher_.visits = 0;
    world_.stepSimulation(btScalar(TestWorld::kTimeStep), 0);
    int contacts = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      contacts += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
    }
    return contacts;
  }
  int Visits() const { return dispatcher_.visits; }
  int Pairs() { return world_.getPairCache()->getNumOverlappingPairs(); }

  btRigidBody& a() { return *a_; }
  btRigidBody& b() { return *b_; }
  btConvexHullShape& hull() { return *hull_; }
  VisitCounter& dispatcher() { return dispatcher_; }
  btDiscreteDynamicsWorld& world() { return world_; }

 private:
  Random random_{TestSeed()};
  std::shared_ptr<btConvexHullShape> hull_ = MakeRandomHull(random_, 40, 1), other_ = MakeRandomHull(random_, 40, 1);
  dgd_bullet::CollisionConfiguration configuration_;
  VisitCounter dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::unique_ptr<btRigidBody> a_ = MakeRigidBody(*hull_, 1, btTransform::getIdentity());
  std::unique_ptr<btRigidBody> b_ =
      MakeRigidBody(*other_, 1, MakeTransform(Eigen::Matrix3d::Identity(), {0.8, 0.8, 0.1}));
};

/// A near callback of an app's own.
void VisitPair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

TEST(CollisionDispatcher, PairThatStaysApart_IsNotVisited) {
  TwoHulls hulls;
  for (int step = 0; step < 3; ++step) ASSERT_EQ(hulls.Step(), 0);
  ASSERT_EQ(hulls.Pairs(), 1);
  for (int step = 0; step < 5; ++step) {
    EXPECT_EQ(hulls.Step(), 0);
    EXPECT_EQ(hulls.Visits(), 0);
  }
}

// What makes the two touch, or meet within the step, in the step in which an app does so.
TEST(CollisionDispatcher, WhateverEndsASeparation_IsSeenAtOnce) {
  btSphereShape large_sphere(btScalar(0.8));
  const std::vector<std::pair<std::string, std::function<void(TwoHulls&)>>> changes = {
      {"another point", [](TwoHulls& hulls) { hulls.hull().addPoint(Vec(0.8, 0.8, 0.1)); }},
      {"a point elsewhere",
       [](TwoHulls& hulls) {
         for (int i = 0; i < hulls.hull().getNumPoints(); ++i) hulls.hull().getUnscaledPoints()[i] *= btScalar(2);
         hulls.hull().recalcLocalAabb();
       }},
      {"scaling", [](TwoHulls& hulls) { hulls.hull().setLocalScaling(Vec(1.5, 1.5, 1.5)); }},
      {"margin", [](TwoHulls& hulls) { hulls.hull().setMargin(btScalar(0.4)); }},
      {"another shape", [&](TwoHulls& hulls) { hulls.a().setCollisionShape(&large_sphere); }},
      {"another place", [](TwoHulls& hulls) { hulls.b().getWorldTransform().setOrigin(Vec(0.6, 0.6, 0.1)); }},
      {"speed", [](TwoHulls& hulls) { hulls.a().setLinearVelocity(Vec(60, 60, 0)); }},
      {"force", [](TwoHulls& hulls) { hulls.a().applyCentralForce(Vec(15000, 15000, 0)); }},
      {"contact distance",
       [](TwoHulls& hulls) {
         // Until their bounding boxes part, pairs keep their algorithm.
         dgd_bullet::Options options;
         options.contact_distance = 0.5;
         options.speculative_contacts = false;
         dgd_bullet::Register(hulls.dispatcher(), options);
         hulls.world().getPairCache()->cleanProxyFromPairs(hulls.a().getBroadphaseHandle(), &hulls.dispatcher());
       }},
  };
  for (const auto& [name, change] : changes) {
    TwoHulls hulls, visited;
    visited.dispatcher().setNearCallback(VisitPair);
    for (int step = 0; step < 5; ++step) {
      ASSERT_EQ(hulls.Step(), 0);
      ASSERT_EQ(visited.Step(), 0);
    }
    ASSERT_EQ(hulls.Visits(), 0);
    for (TwoHulls* each : {&hulls, &visited}) change(*each);
    const int contacts = visited.Step();
    EXPECT_EQ(hulls.Step(), contacts) << name;
    EXPECT_EQ(hulls.Visits(), 1) << name;
    if (name != "force") {
      EXPECT_GT(contacts, 0) << name;
    }
  }
}

// Within the contact distance, which is the manifold's breaking threshold: a centimetre.
TEST(CollisionDispatcher, BodiesThatAreClose_HaveContactsBeforeTheyTouch) {
  TwoHulls hulls;
  btSphereShape ball(btScalar(0.5));
  const auto place = [&](double gap) {
    hulls.b().getWorldTransform().setOrigin(Vec(1 + gap, 0, 0).rotate(Vec(0, 0, 1), SIMD_PI / 4));
  };
  for (btRigidBody* body : {&hulls.a(), &hulls.b()}) body->setCollisionShape(&ball);
  place(0.1);
  for (int step = 0; step < 5; ++step) ASSERT_EQ(hulls.Step(), 0);
  ASSERT_EQ(hulls.Visits(), 0);
  place(0.005);
  EXPECT_EQ(hulls.Step(), 1);
}

// A rod that turns next to a box approaches it by its rotation alone.
TEST(CollisionDispatcher, TurningRod_Touches) {
  TwoHulls hulls;
  btCapsuleShape rod(btScalar(0.1), 2);
  hulls.a().setCollisionShape(&rod);
  hulls.a().setAngularVelocity(Vec(0, 0, -2));
  int steps_apart = 0;
  while (hulls.Step() == 0 && steps_apart < 1000) ++steps_apart;
  EXPECT_GT(steps_apart, 5);
  EXPECT_LT(steps_apart, 200);
}

TEST(CollisionDispatcher, ContactsMadeUnderANearCallback_EndAfterIt) {
  TwoHulls hulls;
  const btTransform apart = hulls.b().getWorldTransform();
  for (int step = 0; step < 5; ++step) ASSERT_EQ(hulls.Step(), 0);
  hulls.dispatcher().setNearCallback(VisitPair);
  hulls.b().getWorldTransform().setOrigin(Vec(0.6, 0.6, 0.1));
  ASSERT_GT(hulls.Step(), 0);
  hulls.dispatcher().setNearCallback(btCollisionDispatcher::defaultNearCallback);
  for (btRigidBody* body : {&hulls.a(), &hulls.b()}) {
    body->setLinearVelocity(Vec(0, 0, 0));
    body->setAngularVelocity(Vec(0, 0, 0));
  }
  hulls.a().setWorldTransform(btTransform::getIdentity());
  hulls.b().setWorldTransform(apart);
  EXPECT_EQ(hulls.Step(), 0);
  EXPECT_EQ(hulls.Pairs(), 1);
}

TEST(CollisionDispatcher, CallbackThatThrows_LeavesADispatcherThatWorks) {
  TwoHulls hulls;
  for (int step = 0; step < 5; ++step) ASSERT_EQ(hulls.Step(), 0);
  hulls.b().getWorldTransform().setOrigin(Vec(0.6, 0.6, 0.1));
  gContactStartedCallback = [](btPersistentManifold* const&) { throw std::runtime_error("by an app"); };
  EXPECT_THROW(hulls.Step(), std::runtime_error);
  gContactStartedCallback = nullptr;
  EXPECT_GT(hulls.Step(), 0);
  // As a pair that has never touched.
  hulls.b().getWorldTransform().setOrigin(Vec(0.8, 0.8, 0.1));
  hulls.world().getPairCache()->cleanProxyFromPairs(hulls.a().getBroadphaseHandle(), &hulls.dispatcher());
  for (int step = 0; step < 5; ++step) EXPECT_EQ(hulls.Step(), 0);
  EXPECT_EQ(hulls.Visits(), 0);
}

struct CountingObserver final : dgd_bullet::PairObserver {
  void OnPair(const btCollisionObjectWrapper&, const btCollisionObjectWrapper&) noexcept override { ++pairs; }
  int pairs = 0;
};

// Each of them sees the pair in each step, as with btCollisionDispatcher.
TEST(CollisionDispatcher, ObserverAndNearCallback_SeePairsThatStayApart) {
  TwoHulls hulls;
  for (int step = 0; step < 5; ++step) hulls.Step();
  hulls.dispatcher().setNearCallback(VisitPair);
  hulls.Step();
  EXPECT_EQ(hulls.Visits(), 1);
  CountingObserver observer;
  dgd_bullet::Options options;
  options.pair_observer = &observer;
  TwoHulls observed(options);
  for (int step = 0; step < 5; ++step) observed.Step();
  EXPECT_EQ(observer.pairs, 5);
}

/// The bodies of the pairs that an app's near callback has seen, and on which threads.
std::vector<std::pair<int, int>> near_pairs;
std::atomic<int> near_calls_elsewhere;
std::thread::id near_thread;

void NoteAndVisit(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  if (std::this_thread::get_id() != near_thread) {
    ++near_calls_elsewhere;
    return;
  }
  const auto index_of = [](const btBroadphaseProxy* proxy) {
    return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getWorldArrayIndex();
  };
  near_pairs.emplace_back(index_of(pair.m_pProxy0), index_of(pair.m_pProxy1));
  btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}

TEST(CollisionDispatcher, NearCallback_IsCalledForThePairsOfBulletsDispatcherOnTheSteppingThread) {
  near_thread = std::this_thread::get_id();
  near_calls_elsewhere = 0;
  Crowd expected(std::nullopt), crowd(Threads(2));
  for (int step = 0; step < 40; ++step) {
    std::array<std::vector<std::pair<int, int>>, 2> seen;
    for (Crowd* each : {&expected, &crowd}) {
      // Set and reset, as an app may at any time.
      each->world().dispatcher().setNearCallback(step % 20 < 10 ? btCollisionDispatcher::defaultNearCallback
                                                                : NoteAndVisit);
      near_pairs.clear();
      each->Step();
      seen[each == &crowd] = near_pairs;
    }
    ASSERT_EQ(crowd.Read(), expected.Read()) << "step " << step;
    EXPECT_EQ(seen[1], seen[0]);
    EXPECT_EQ(seen[0].size() > 100, step % 20 >= 10);
  }
  EXPECT_EQ(near_calls_elsewhere, 0);
}

/// Counts what it is shown, and on which threads.
class ThreadChecker : public btIDebugDraw {
 public:
  void drawLine(const btVector3&, const btVector3&, const btVector3&) override {
    ++lines;
    lines_elsewhere += std::this_thread::get_id() != thread_;
  }
  void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
  void reportErrorWarning(const char* text) override { ADD_FAILURE() << text; }
  void draw3dText(const btVector3&, const char*) override {}
  void setDebugMode(int) override {}
  int getDebugMode() const override { return DBG_DrawContactPoints; }

  std::atomic<int> lines = 0, lines_elsewhere = 0;

 private:
  const std::thread::id thread_ = std::this_thread::get_id();
};

TEST(CollisionDispatcher, DebugDrawer_IsCalledOnTheSteppingThread) {
  ThreadChecker checker;
  Crowd crowd(Threads(2));
  for (int step = 0; step < 30; ++step) crowd.Step();
  crowd.world().world().setDebugDrawer(&checker);
  crowd.Step();
  crowd.world().world().setDebugDrawer(nullptr);
  EXPECT_GT(checker.lines, 100);
  EXPECT_EQ(checker.lines_elsewhere, 0);
}

std::atomic<int> started, ended;

TEST(CollisionDispatcher, ContactsThatStartAndEnd_AreReportedAsByBulletsDispatcher) {
  gContactStartedCallback = [](btPersistentManifold* const&) { ++started; };
  gContactEndedCallback = [](btPersistentManifold* const&) { ++ended; };
  std::array<std::array<int, 2>, 2> counts{};
  for (const bool is_plain : {true, false}) {
    started = ended = 0;
    Crowd crowd(is_plain ? DispatcherChoice() : Threads(3));
    for (int step = 0; step < kSteps; ++step) crowd.Step();
    counts[is_plain] = {started, ended};
  }
  gContactStartedCallback = nullptr;
  gContactEndedCallback = nullptr;
  EXPECT_EQ(counts[false], counts[true]);
  EXPECT_GT(counts[true][0], 100);
  EXPECT_GT(counts[true][1], 10);
}

TEST(CollisionDispatcher, BuiltinNarrowphase_GoesOnWorking) {
  btDefaultCollisionConfiguration configuration;
  dgd_bullet::CollisionDispatcher dispatcher(&configuration, Threads(2));
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btBoxShape cube(Vec(1, 1, 1));
  btCollisionObject lower, upper;
  upper.getWorldTransform().setOrigin(Vec(0, 0, 1.999));
  for (btCollisionObject* body : {&lower, &upper}) {
    body->setCollisionShape(&cube);
    world.addCollisionObject(body);
  }
  world.performDiscreteCollisionDetection();
  ASSERT_EQ(dispatcher.getNumManifolds(), 1);
  EXPECT_EQ(dispatcher.getManifoldByIndexInternal(0)->getNumContacts(), 4);
  for (btCollisionObject* body : {&lower, &upper}) world.removeCollisionObject(body);
  EXPECT_EQ(dispatcher.getNumManifolds(), 0);
}

template <class Call>
std::string MessageOf(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(CollisionDispatcher, BadOptions_AreNamedWithTheirValue) {
  dgd_bullet::CollisionConfiguration configuration;
  for (const int threads : {-1, 0, 65}) {
    EXPECT_EQ(MessageOf([&] { dgd_bullet::CollisionDispatcher dispatcher(&configuration, Threads(threads)); }),
              "dgd_bullet::DispatcherOptions::threads must be 1 to 64; got " + std::to_string(threads));
  }
  EXPECT_EQ(MessageOf([] { dgd_bullet::CollisionDispatcher dispatcher(nullptr); }),
            "dgd_bullet::CollisionDispatcher needs a collision configuration; got null");
  // More threads than most machines have.
  dgd_bullet::CollisionDispatcher dispatcher(&configuration, Threads(64));
}

TEST(CollisionDispatcher, AnotherVersionOfBullet_IsRefused) {
  dgd_bullet::CollisionConfiguration configuration;
  EXPECT_THROW(dgd_bullet::CollisionDispatcher(&configuration, {}, BT_BULLET_VERSION + 1), std::runtime_error);
}

}  // namespace
}  // namespace dgd_test
