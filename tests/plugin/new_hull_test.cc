// Hulls that no query has seen before: their first answers are as good as all that follow, and the same.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

/// More than a hull is scanned for (hull_cache.cc).
constexpr int kQueries = 300;

void ExpectSame(const std::vector<Contact>& contacts, const std::vector<Contact>& expected) {
  ASSERT_EQ(contacts.size(), expected.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(contacts[i].normal_b_to_a, expected[i].normal_b_to_a);
    EXPECT_EQ(contacts[i].on_b, expected[i].on_b);
    EXPECT_EQ(contacts[i].depth, expected[i].depth);
  }
}

TEST(NewHull, AllQueries_HaveTheSameContactsToTheLastBit) {
  Dispatching dispatching(Route::kConfiguration);
  Random random(TestSeed());
  btBoxShape box(Vec(0.3, 0.4, 0.5));
  btCylinderShape cylinder(Vec(0.3, 0.4, 0.3));
  std::vector<std::shared_ptr<btConvexHullShape>> hulls = {MakePrism(4, 0.5, 0.3), MakePrism(12, 0.5, 0.3)};
  for (const int count : {5, 8, 20, 40, 64}) hulls.push_back(MakeRandomHull(random, count, 1));
  int touching = 0;
  for (const auto& hull : hulls) {
    const auto other = MakeRandomHull(random, 20, 1);
    for (btConvexShape* partner : {static_cast<btConvexShape*>(&box), static_cast<btConvexShape*>(&cylinder),
                                   static_cast<btConvexShape*>(other.get())}) {
      PairQuery pair(dispatching.dispatcher(), *hull, *partner);
      pair.SetPoses(MakeTransform(random.Rotation(), {0, 0, 0}),
                    MakeTransform(random.Rotation(), random.Uniform(0.4, 0.8) * random.UnitVector()));
      const std::vector<Contact> first = pair.ClosestPoints(0.1), of_first_test = pair.ContactTest();
      for (int i = 0; i < kQueries; ++i) {
        ExpectSame(pair.ClosestPoints(0.1), first);
        ExpectSame(pair.ContactTest(), of_first_test);
      }
      touching += !of_first_test.empty();
    }
  }
  EXPECT_GT(touching, 5);
}

// What is scanned at first is climbed later.
TEST(NewHull, OfManyPoints_AllQueriesAgreeButForRoundoff) {
  constexpr double kRoundoff = sizeof(btScalar) == sizeof(double) ? 1e-12 : 1e-6;  // Of metres, and of a unit vector.
  Dispatching dispatching(Route::kConfiguration);
  Random random(TestSeed());
  for (const int count : {65, 200}) {
    const auto a = MakeRandomHull(random, count, 1), b = MakeRandomHull(random, count, 1);
    PairQuery pair(dispatching.dispatcher(), *a, *b);
    pair.SetPoses(btTransform::getIdentity(), At(0.8, 0.1, 0.2));
    const std::vector<Contact> first = pair.ContactTest();
    ASSERT_FALSE(first.empty());
    for (int i = 0; i < kQueries; ++i) {
      const std::vector<Contact> contacts = pair.ContactTest();
      // Where two edges cross, roundoff decides which end of each counts, and so which facets the patch is of.
      ASSERT_FALSE(contacts.empty());
      EXPECT_NEAR(Deepest(contacts).depth, Deepest(first).depth, kRoundoff);
      EXPECT_NEAR((Deepest(contacts).normal_b_to_a - Deepest(first).normal_b_to_a).norm(), 0, kRoundoff);
    }
  }
}

TEST(NewHull, FirstStep_HasTheWholePatch) {
  Dispatching dispatching(Route::kConfiguration);
  btBoxShape floor(Vec(5, 5, 1));
  for (const int sides : {3, 4, 6, 30, 50}) {  // The last has more than 64 points.
    const auto prism = MakePrism(sides, 0.5, 0.3);
    PairQuery pair(dispatching.dispatcher(), *prism, floor);
    btTransform pose = btTransform::getIdentity();
    pose.getOrigin().setZ(btScalar(0.3) + prism->getMargin() - btScalar(0.001));
    pair.SetPoses(pose, At(0, 0, -1));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_EQ(contacts.size(), sides == 3 ? 3U : 4U) << sides;
    for (const Contact& contact : contacts) {
      EXPECT_NEAR(contact.depth, -0.001, 1e-5);
      EXPECT_NEAR(std::hypot(contact.on_b.x(), contact.on_b.y()), 0.5, 0.01) << sides;
    }
  }
}

// Whichever thread builds its facets, and whatever the others are at.
TEST(NewHull, SharedByThreads_HasTheSameContactsInAllOfThem) {
  constexpr int kThreads = 4, kRounds = 10;
  Dispatching dispatching(Route::kConfiguration);
  Random random(TestSeed());
  for (int round = 0; round < kRounds; ++round) {
    const auto a = MakeRandomHull(random, 20, 1), b = MakeRandomHull(random, 12, 1);
    std::vector<std::unique_ptr<PairQuery>> pairs;
    for (int thread = 0; thread < kThreads; ++thread) {
      pairs.push_back(std::make_unique<PairQuery>(dispatching.dispatcher(), *a, *b));
      pairs.back()->SetPoses(btTransform::getIdentity(), At(0.5, 0, 0));
      pairs.back()->Step();
    }
    std::vector<std::vector<Contact>> contacts(kThreads);
    const auto work = [&](std::size_t thread) {
      for (int i = 0; i < kQueries; ++i) {
        // To and fro, for bodies that lie still keep their contacts.
        pairs[thread]->SetPoses(btTransform::getIdentity(), At(0.5 + 0.01 * (i % 2), 0, 0));
        const std::vector<Contact> found = pairs[thread]->Step();
        contacts[thread].insert(contacts[thread].end(), found.begin(), found.end());
      }
    };
    std::vector<std::thread> workers;
    for (std::size_t thread = 1; thread < kThreads; ++thread) workers.emplace_back(work, thread);
    work(0);
    for (std::thread& worker : workers) worker.join();
    for (std::size_t thread = 1; thread < kThreads; ++thread) ExpectSame(contacts[thread], contacts[0]);
  }
}

}  // namespace
}  // namespace dgd_test
