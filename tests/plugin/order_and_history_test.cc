// What a pair's contacts do not depend on: which body Bullet names first, and, if asked for, what was before.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

/// Two bodies of half a metre, from just apart to overlapping.
void PlaceNearby(Random& random, PairQuery& pair, double distance) {
  pair.SetPoses(MakeTransform(random.Rotation(), random.InCube()), MakeTransform(random.Rotation(), {0, 0, 0}));
  pair.body_b().getWorldTransform().setOrigin(pair.body_a().getWorldTransform().getOrigin() +
                                              ToBullet(distance * random.UnitVector()));
}

/// As if the bodies had been named the other way round.
std::vector<Contact> Swapped(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) {
    contact.on_b = contact.OnA();
    contact.normal_b_to_a = -contact.normal_b_to_a;
  }
  return contacts;
}

TEST(PairOrder, SwappedBodies_HaveTheSameContactsToTheLastBit) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.5);
  Dispatching dispatching(Route::kConfiguration);
  Random random(TestSeed());
  int touching = 0;
  for (const ZooShape& a : zoo) {
    for (const ZooShape& b : zoo) {
      SCOPED_TRACE(a.name + " and " + b.name);
      PairQuery pair(dispatching.dispatcher(), *a.shape, *b.shape);
      PairQuery swapped(dispatching.dispatcher(), *b.shape, *a.shape);
      for (int step = 0; step < 4; ++step) {
        // The last ones go on from the one before.
        if (step < 2) PlaceNearby(random, pair, random.Uniform(0.2, 0.6));
        if (step >= 2) pair.body_b().getWorldTransform().getOrigin() += ToBullet(0.002 * random.UnitVector());
        swapped.SetPoses(pair.body_b().getWorldTransform(), pair.body_a().getWorldTransform());
        const std::vector<Contact> contacts = pair.Step(), others = Swapped(swapped.Step());
        ASSERT_EQ(contacts.size(), others.size());
        touching += !contacts.empty();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
          EXPECT_EQ(contacts[i].normal_b_to_a, others[i].normal_b_to_a);
          EXPECT_EQ(contacts[i].depth, others[i].depth);
          // Bullet is told of one of the two points, and of another when swapped.
          EXPECT_LE((contacts[i].on_b - others[i].on_b).norm(), sizeof(btScalar) == 8 ? 1e-15 : 5e-7);
        }
      }
    }
  }
  EXPECT_GT(touching, int(zoo.size() * zoo.size()));
}

TEST(PairOrder, BodiesThatPassEachOther_GoOnFromTheLastQuery) {
  // Their order changes where they are level across the direction that decides it.
  Dispatching dispatching(Route::kConfiguration);
  btBoxShape box(Vec(0.25, 0.25, 0.25));
  PairQuery pair(dispatching.dispatcher(), box, box);
  for (int step = -20; step <= 20; ++step) {
    const double x = 0.01 * step;
    pair.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0}),
                  MakeTransform(Eigen::Matrix3d::Identity(), {x, -x, 0.499}));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_EQ(contacts.size(), 4U) << x;
    for (const Contact& contact : contacts) {
      EXPECT_NEAR(contact.depth, -0.001, 1e-6) << x;
      EXPECT_NEAR((contact.normal_b_to_a + Vector::UnitZ()).norm(), 0, 1e-6) << x;
    }
  }
}

/// Turns body B and brings it nearer, step by step, until a pair that was never asked before has contacts; expects
/// those of a pair that was asked all along.
/// @return  Whether they met.
bool MeetAsSoonAsANewPair(Random& random, btConvexShape& a, btConvexShape& b) {
  Dispatching dispatching(Route::kConfiguration);
  PairQuery pair(dispatching.dispatcher(), a, b);
  PlaceNearby(random, pair, 1);
  const btVector3 axis = ToBullet(random.UnitVector());
  for (int step = 0; step < 60; ++step) {
    btTransform& pose_b = pair.body_b().getWorldTransform();
    pose_b.getOrigin() =
        btScalar(0.97) * pose_b.getOrigin() + btScalar(0.03) * pair.body_a().getWorldTransform().getOrigin();
    pose_b.getBasis() = btMatrix3x3(btQuaternion(axis, btScalar(0.02))) * pose_b.getBasis();
    PairQuery fresh(dispatching.dispatcher(), a, b);
    fresh.SetPoses(pair.body_a().getWorldTransform(), pose_b);
    const std::vector<Contact> contacts = pair.Step(), firsts = fresh.Step();
    if (firsts.empty()) continue;
    if (contacts.empty()) {
      // Within rounding of the distance up to which there are any.
      EXPECT_NEAR(Deepest(firsts).depth, double(fresh.manifold()->getContactBreakingThreshold()), 1e-5) << step;
    }
    return true;
  }
  return false;
}

// While a pair is apart, its last normal answers for it, step after step: never longer than it is.
TEST(PairHistory, BodiesThatComeNearer_HaveContactsAsSoonAsANewPairHas) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.5);
  Random random(TestSeed());
  int met = 0;
  for (const ZooShape& a : zoo) {
    for (const ZooShape& b : zoo) {
      SCOPED_TRACE(a.name + " and " + b.name);
      met += MeetAsSoonAsANewPair(random, *a.shape, *b.shape);
    }
  }
  EXPECT_GT(met, int(zoo.size() * zoo.size()) * 9 / 10);
}

/// Bullet's own points answer there, some at a time: none is left out, whatever their number.
TEST(PairHistory, HullsThatComeNearer_HaveContactsAsSoonAsANewPairHas) {
  btSphereShape ball(btScalar(0.25));
  Random random(TestSeed());
  int met = 0, pairs = 0;
  for (int count = 4; count <= 24; ++count) {
    SCOPED_TRACE(count);
    const auto points = MakeRandomHull(random, count, 0.5);
    for (int i = 0; i < 10; ++i, ++pairs) {
      // Each point is the last of its hull in turn.
      btConvexHullShape hull;
      for (int k = 0; k < count; ++k) hull.addPoint(points->getScaledPoint((k + i) % count));
      met += MeetAsSoonAsANewPair(random, hull, ball);
    }
  }
  EXPECT_GT(met, pairs * 9 / 10);
}

dgd_bullet::Options WithoutHistory() {
  dgd_bullet::Options options;
  options.warm_start = false;
  return options;
}

/// Whether each step's raw contacts are those of a pair that has never been asked before.
bool IsWithoutHistory(const dgd_bullet::Options& options) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.5);
  Dispatching dispatching(Route::kConfiguration, options);
  Random random(TestSeed());
  bool is_same = true;
  for (const ZooShape& a : zoo) {
    for (const ZooShape& b : zoo) {
      PairQuery pair(dispatching.dispatcher(), *a.shape, *b.shape);
      PlaceNearby(random, pair, 0.4);
      for (int step = 0; step < 3; ++step) {
        PairQuery fresh(dispatching.dispatcher(), *a.shape, *b.shape);
        fresh.SetPoses(pair.body_a().getWorldTransform(), pair.body_b().getWorldTransform());
        const std::vector<Contact> contacts = pair.Step(), firsts = fresh.Step();
        is_same = is_same && contacts.size() == firsts.size();
        for (std::size_t i = 0; is_same && i < contacts.size(); ++i) {
          is_same = contacts[i].normal_b_to_a == firsts[i].normal_b_to_a && contacts[i].on_b == firsts[i].on_b &&
                    contacts[i].depth == firsts[i].depth;
        }
        pair.body_b().getWorldTransform().getOrigin() += ToBullet(0.002 * random.UnitVector());
      }
    }
  }
  return is_same;
}

TEST(WarmStartOption, Off_EveryStepIsAsTheFirst) { EXPECT_TRUE(IsWithoutHistory(WithoutHistory())); }
TEST(WarmStartOption, On_LastDigitsTellWhatWasBefore) { EXPECT_FALSE(IsWithoutHistory({})); }

/// A pile that falls, and what a save of it holds: the bodies, and the manifolds with their points.
class Pile {
 public:
  explicit Pile(const dgd_bullet::Options& options) : world_(Route::kConfiguration, options) {
    world_.world().getDispatchInfo().m_deterministicOverlappingPairs = true;
    world_.AddGround();
    Random random(TestSeed());
    // Curved: what a query ends with depends on where it began, in more digits than float has.
    btConeShape& stone = world_.Make<btConeShape>(btScalar(0.2), btScalar(0.3));
    for (int i = 0; i < 12; ++i) {
      const btTransform pose = MakeTransform(random.Rotation(), {0.1 * (i % 2), 0, 0.5 + 0.35 * i});
      bodies_.push_back(&world_.Add(stone, 1, pose));
      bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    }
  }

  struct Body {
    btTransform pose;
    btVector3 velocity, angular_velocity;
    bool operator==(const Body& other) const {
      return pose == other.pose && velocity == other.velocity && angular_velocity == other.angular_velocity;
    }
  };
  using Pair = std::pair<const btCollisionObject*, const btCollisionObject*>;
  struct Save {
    std::vector<Body> bodies;
    std::map<Pair, std::vector<btManifoldPoint>> manifolds;  // Those with points.
  };

  void Run(int steps) { world_.Simulate(steps * TestWorld::kTimeStep); }

  Save Saved() {
    Save save;
    for (const btRigidBody* body : bodies_) {
      save.bodies.push_back({body->getWorldTransform(), body->getLinearVelocity(), body->getAngularVelocity()});
    }
    ForEachManifold([&save](const Pair& pair, const btPersistentManifold& manifold) {
      for (int i = 0; i < manifold.getNumContacts(); ++i) save.manifolds[pair].push_back(manifold.getContactPoint(i));
    });
    return save;
  }

  /// Of a save so recent that its pairs still have their manifolds.
  void Restore(const Save& save) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i]->setWorldTransform(save.bodies[i].pose);
      bodies_[i]->setInterpolationWorldTransform(save.bodies[i].pose);
      bodies_[i]->updateInertiaTensor();
      bodies_[i]->setLinearVelocity(save.bodies[i].velocity);
      bodies_[i]->setAngularVelocity(save.bodies[i].angular_velocity);
    }
    std::size_t restored = 0;
    ForEachManifold([&](const Pair& pair, btPersistentManifold& manifold) {
      manifold.setNumContacts(0);
      const auto saved = save.manifolds.find(pair);
      if (saved == save.manifolds.end()) return;
      ++restored;
      manifold.setNumContacts(int(saved->second.size()));
      for (int i = 0; i < manifold.getNumContacts(); ++i) {
        manifold.getContactPoint(i) = saved->second[std::size_t(i)];
      }
    });
    ASSERT_EQ(restored, save.manifolds.size());
  }

 private:
  template <class Visit>
  void ForEachManifold(const Visit& visit) {
    for (int i = 0; i < world_.dispatcher().getNumManifolds(); ++i) {
      btPersistentManifold& manifold = *world_.dispatcher().getManifoldByIndexInternal(i);
      visit(Pair(manifold.getBody0(), manifold.getBody1()), manifold);
    }
  }

  TestWorld world_;
  std::vector<btRigidBody*> bodies_;
};

/// Of a world that is saved, run, restored and run again, and that at a few moments in the midst of its fall: how often
/// it ends in other bits.
int CountOtherReplays(const dgd_bullet::Options& options) {
  Pile pile(options);
  pile.Run(120);
  int others = 0;
  for (int moment = 0; moment < 6; ++moment) {
    pile.Run(12);
    const Pile::Save save = pile.Saved();
    pile.Run(8);
    const Pile::Save first = pile.Saved();
    EXPECT_FALSE(save.bodies == first.bodies);
    pile.Restore(save);
    pile.Run(8);
    if (!(pile.Saved().bodies == first.bodies)) ++others;
  }
  return others;
}

TEST(WarmStartOption, Off_ARestoredWorldGoesOnBitByBitAsTheSavedOne) {
  EXPECT_EQ(CountOtherReplays(WithoutHistory()), 0);
}
// The digits that tell are the solver's last, which a world in float most often rounds away.
TEST(WarmStartOption, On_ARestoredWorldInDoubleRemembersMore) {
  if (sizeof(btScalar) == 8) {
    EXPECT_GT(CountOtherReplays({}), 0);
  }
}

}  // namespace
}  // namespace dgd_test
