// What an app may do wrong, or run out of: shapes whose support functions lie, bodies whose poses are no numbers among
// others, pools that are full. No crash and no contact that is not finite; it is counted, and told once a kind.
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plugin/fallback_fixture.h"
#include "plugin/lying_shape.h"
#include "plugin/shape_zoo.h"

namespace dgd_test {
namespace {

const btScalar kNaN = std::numeric_limits<btScalar>::quiet_NaN();

/// What has been told; a function pointer takes no object along.
std::vector<std::string>& Told() {
  static std::vector<std::string> told;
  return told;
}

dgd_bullet::Options Listening(int max_iterations = dgd_bullet::Options().max_iterations) {
  Told().clear();
  dgd_bullet::Options options;
  options.max_iterations = max_iterations;
  options.on_first_fallback = [](const char* message) noexcept { Told().emplace_back(message); };
  return options;
}

class LyingShapes : public Fallback {};

TEST_F(LyingShapes, AgainstAllShapes_OnlyFiniteContacts) {
  Dispatching dispatching(Route::kConfiguration, Listening());
  Random random(TestSeed());
  const std::vector<ZooShape> zoo = MakeShapeZoo(1);
  for (const Lie lie : kLies) {
    LyingShape liar(lie), other(lie);
    liar.setMargin(btScalar(0.04));
    other.setMargin(0);
    for (std::size_t i = 0; i <= zoo.size(); ++i) {
      btConvexShape& partner = i < zoo.size() ? *zoo[i].shape : static_cast<btConvexShape&>(other);
      SCOPED_TRACE(std::string(NameOf(lie)) + " against " + (i < zoo.size() ? zoo[i].name : "itself"));
      PairQuery pair(dispatching.dispatcher(), liar, partner);
      for (int step = 0; step < 20; ++step) {
        const double distance = random.Uniform(0, 1.2);
        pair.SetPoses(MakeTransform(random.Rotation(), distance * random.UnitVector()),
                      MakeTransform(random.Rotation(), Vector::Zero()));
        ExpectFinite(pair, pair.Step());
        ExpectFinite(pair, pair.ClosestPoints(0.1));
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(dispatching.statistics().fallbacks_invalid, 0U);
  EXPECT_GT(dispatching.statistics().fallbacks_not_converged, 0U);
  EXPECT_EQ(Told().size(), 2U) << "one line a kind";
}

// A shape that tells the truth again is treated as any other.
TEST_F(LyingShapes, OnceHonest_AnswersAreRight) {
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  for (const Lie lie : kLies) {
    SCOPED_TRACE(NameOf(lie));
    LyingShape shape(lie);
    PairQuery pair(dispatching_.dispatcher(), shape, box);
    pair.SetPoses(At(0.02, 0.01, 0.5 + 0.3 + 0.04 - 0.01), btTransform::getIdentity());
    for (int step = 0; step < 3; ++step) pair.Step();
    shape.Tell(Lie::kNone);
    const std::vector<Contact> contacts = pair.Step();
    ExpectSound(pair, contacts);
    EXPECT_NEAR(Deepest(contacts).depth, -0.01, 1e-4);
  }
}

// Found by fuzz_plugin_world: lengths whose products are infinite in float.
TEST(HostileWorld, BodiesAsLargeAsNumbersGo_OnlyFiniteContacts) {
  Dispatching dispatching(Route::kConfiguration, Listening());
  for (const double size : {1e14, 1e18, 1e25, 1e30, 3e38}) {
    btSphereShape sphere{btScalar(size)};
    btBoxShape box(Vec(size, size, size)), small(Vec(1, 1, 1));
    btConvexShape* const shapes[] = {&sphere, &box, &small};
    for (btConvexShape* a : shapes) {
      for (btConvexShape* b : shapes) {
        PairQuery pair(dispatching.dispatcher(), *a, *b);
        for (const double distance : {0.0, 0.1, 0.5, 1.0}) {
          pair.SetPoses(At(0, 0.3 * distance * size, distance * size), btTransform::getIdentity());
          for (const Contact& contact : pair.Step()) EXPECT_TRUE(std::isfinite(contact.depth)) << size;
          if (pair.manifold() == nullptr) continue;
          for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
            const btManifoldPoint& point = pair.manifold()->getContactPoint(i);
            EXPECT_TRUE(std::isfinite(point.getDistance())) << size;
            EXPECT_TRUE(ToEigen(point.getPositionWorldOnA()).allFinite()) << size;
          }
        }
      }
    }
  }
}

// Found by fuzz_plugin_world: what is left to Bullet's GJK goes to an app that asks, without a manifold in between.
// Scaled in float, the hull's points are infinite.
TEST(HostileWorld, AppAsksAboutAHullScaledBeyondNumbers_OnlyFiniteContacts) {
  Dispatching dispatching(Route::kConfiguration, Listening());
  btCapsuleShape capsule(btScalar(1.38232422), 0);
  btConvexHullShape hull;
  for (const btVector3& point : {Vec(0.230834961, 0.33605957, -1.22436523), Vec(-1.4720459, 1.9095459, 0.52746582),
                                 Vec(0.907348633, -1.67443848, 1.36553955), Vec(0.244812012, 1.84143066, 1.14227295)}) {
    hull.addPoint(point, false);
  }
  PairQuery pair(dispatching.dispatcher(), capsule, hull);
  Eigen::Matrix3d turn;
  turn << 0.0170969367, 0.221851736, 0.974930525, -0.0121462271, -0.974955082, 0.222070307, 0.999780059, -0.0156384557,
      -0.0139740705;
  pair.SetPoses(At(0, 0, -1), MakeTransform(turn, Vector(-2.34399414, -1.03613281, 4.75478697)));
  for (const double scale : {3.40282e38, 1e38, 1e30, 1e20}) {
    hull.setLocalScaling(Vec(-7.20703, 8.34183e-17, scale));
    std::vector<Contact> contacts = pair.ContactTest();
    for (const Contact& contact : pair.ClosestPoints(0.935303)) contacts.push_back(contact);
    for (const Contact& contact : contacts) {
      EXPECT_TRUE(std::isfinite(contact.depth) && contact.normal_b_to_a.allFinite() && contact.on_b.allFinite())
          << scale;
    }
  }
}

// Found by fuzz_plugin_world: a contact may be somewhere, and a body nowhere near it.
TEST(HostileWorld, AppAsksAboutABodyBeyondNumbers_NoContactThatIsInfiniteInItsFrame) {
  Dispatching dispatching(Route::kConfiguration, Listening());
  btCapsuleShape capsule(btScalar(0.5), 1);
  btBoxShape box(Vec(1, 1, 1));
  for (const double distance : {1e14, 1e20, 1e30, 3.4e38}) {
    PairQuery pair(dispatching.dispatcher(), capsule, box);
    btTransform beyond = At(0, 0, distance);
    beyond.setBasis({btScalar(-1.2), btScalar(0.6), btScalar(3.2), btScalar(4.5), btScalar(-1.1), btScalar(3.6),
                     btScalar(-1.2), btScalar(-1.1), btScalar(4.4)});
    pair.SetPoses(beyond, btTransform::getIdentity());
    std::vector<Contact> contacts = pair.ContactTest();
    for (const Contact& contact : pair.ClosestPoints(1)) contacts.push_back(contact);
    for (const Contact& contact : contacts) {
      EXPECT_TRUE(IsFinite(beyond.invXform(ToBullet(contact.OnA())))) << distance;
    }
  }
}

/// The others of a heap do not notice, and the body is one of them again once its pose is.
void ExpectHeapSurvivesNaN(TestWorld& world, btCollisionShape& shape) {
  world.AddGround();
  std::vector<btRigidBody*> bodies;
  for (int i = 0; i < 12; ++i)
    bodies.push_back(&world.Add(shape, 1, Vec(0.05 * (i % 3), 0.05 * (i % 2), 0.3 + 0.61 * i)));
  world.Simulate(0.5);
  btRigidBody& victim = *bodies[4];
  const btTransform last = victim.getWorldTransform();
  for (const bool in_rotation : {false, true}) {
    btTransform none = last;
    if (in_rotation) {
      none.getBasis()[0].setX(kNaN);
    } else {
      none.getOrigin().setY(kNaN);
    }
    victim.setWorldTransform(none);
    world.Simulate(0.25);
    for (const btRigidBody* body : bodies) {
      ASSERT_TRUE(body == &victim || IsFinite(body->getWorldTransform()));
    }
    for (const btManifoldPoint& point : world.Points()) ASSERT_TRUE(std::isfinite(point.getDistance()));
    // As an app brings it back.
    victim.setWorldTransform(last);
    victim.setInterpolationWorldTransform(last);
    victim.setLinearVelocity(Vec(0, 0, 0));
    victim.setAngularVelocity(Vec(0, 0, 0));
    victim.forceActivationState(ACTIVE_TAG);
    world.Simulate(0.25);
    EXPECT_TRUE(IsFinite(victim.getWorldTransform()));
    EXPECT_GT(victim.getWorldTransform().getOrigin().z(), 0.25) << "not through the ground";
  }
}

TEST(HostileWorld, BodyOfNaNPoseInAHeap_OthersStayFiniteAndItComesBack) {
  TestWorld world(Route::kConfiguration, Listening());
  ExpectHeapSurvivesNaN(world, world.Make<btBoxShape>(Vec(0.3, 0.3, 0.3)));
  EXPECT_GT(world.statistics().fallbacks_invalid, 0U);
  ASSERT_EQ(Told().size(), 1U);
  EXPECT_NE(Told()[0].find("BOX and BOX has no contacts"), std::string::npos) << Told()[0];
}

TEST(HostileWorld, CompoundOfNaNPoseInAHeap_OthersStayFiniteAndItComesBack) {
  for (const bool has_tree : {false, true}) {
    for (const int children : {1, 2}) {
      TestWorld world(Route::kConfiguration, Listening());
      auto& compound = world.Make<btCompoundShape>(has_tree);
      auto& part = world.Make<btBoxShape>(Vec(0.3 / children, 0.3, 0.3));
      for (int i = 0; i < children; ++i) compound.addChildShape(At(0.3 * i - 0.15 * (children - 1), 0, 0), &part);
      ExpectHeapSurvivesNaN(world, compound);
    }
  }
}

/// A dispatcher with so many manifolds and no more, and so many algorithms before it asks the heap.
class SmallPools {
 public:
  SmallPools(int manifolds, int algorithms, dgd_bullet::Options options = Listening())
      : configuration_(options, Pools(manifolds, algorithms)) {
    dispatcher_.setDispatcherFlags(dispatcher_.getDispatcherFlags() |
                                   btCollisionDispatcher::CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION);
  }
  btCollisionDispatcher& dispatcher() { return dispatcher_; }
  dgd_bullet::Statistics statistics() const { return configuration_.statistics(); }

 private:
  static btDefaultCollisionConstructionInfo Pools(int manifolds, int algorithms) {
    btDefaultCollisionConstructionInfo pools;
    pools.m_defaultMaxPersistentManifoldPoolSize = manifolds;
    pools.m_defaultMaxCollisionAlgorithmPoolSize = algorithms;
    return pools;
  }
  dgd_bullet::CollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
};

TEST(HostilePools, NoManifoldLeft_NoContactsCountedAndMadeUpForLater) {
  SmallPools pools(2, 100);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  std::vector<std::unique_ptr<PairQuery>> pairs;
  for (int i = 0; i < 3; ++i) {
    pairs.push_back(std::make_unique<PairQuery>(pools.dispatcher(), box, box));
    pairs.back()->SetPoses(At(0, 0, 0.99), btTransform::getIdentity());
  }
  EXPECT_FALSE(pairs[0]->Step().empty());
  EXPECT_FALSE(pairs[1]->Step().empty());
  for (int step = 0; step < 5; ++step) EXPECT_TRUE(pairs[2]->Step().empty());
  EXPECT_EQ(pools.statistics().fallbacks_no_memory, 5U);
  EXPECT_EQ(pools.statistics().Fallbacks(), 5U);
  ASSERT_EQ(Told().size(), 1U);
  EXPECT_NE(Told()[0].find("no memory is left"), std::string::npos) << Told()[0];
  pairs[0].reset();
  EXPECT_FALSE(pairs[2]->Step().empty()) << "a manifold is free now";
  EXPECT_EQ(pools.statistics().fallbacks_no_memory, 5U);
}

// Bullet then asks the heap for algorithms, and so do ours; also for the fallback, which needs none.
TEST(HostilePools, NoAlgorithmLeft_TheHeapHelpsOut) {
  SmallPools pools(100, 1, Listening(1));
  btTriangleShape flat(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  flat.setMargin(0);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery first(pools.dispatcher(), box, box), second(pools.dispatcher(), box, box),
      two_flat(pools.dispatcher(), flat, flat);
  for (PairQuery* pair : {&first, &second}) {
    pair->SetPoses(At(0, 0, 0.99), btTransform::getIdentity());
    EXPECT_FALSE(pair->Step().empty());
  }
  two_flat.SetPoses(At(0, 0, 0.005), btTransform::getIdentity());
  EXPECT_FALSE(two_flat.Step().empty());
  EXPECT_EQ(pools.statistics().fallbacks_no_interior, 1U);
  EXPECT_EQ(pools.statistics().fallbacks_no_memory, 0U);
}

TEST(FallbackLog, EachReasonIsToldOnceWithItsTypes) {
  Dispatching dispatching(Route::kConfiguration, Listening(1));
  btTriangleShape flat(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  flat.setMargin(0);
  btConvexHullShape empty;
  btSphereShape sphere(btScalar(0.5));
  PairQuery two_flat(dispatching.dispatcher(), flat, flat), none(dispatching.dispatcher(), empty, sphere);
  for (int step = 0; step < 3; ++step) {
    two_flat.SetPoses(At(0, 0, 0.005), btTransform::getIdentity());
    two_flat.Step();
    none.Step();
  }
  ASSERT_EQ(Told().size(), 2U);
  EXPECT_EQ(Told()[0],
            "dgd_bullet: a pair of TRIANGLE and TRIANGLE was left to Bullet's GJK/EPA: both are flat, and their"
            " distance did not converge. Reported once; counted in Statistics::fallbacks_no_interior.");
  EXPECT_EQ(Told()[1],
            "dgd_bullet: a pair of CONVEX_HULL and SPHERE has no contacts: a pose or a shape is not finite, or a shape"
            " has no points. Reported once; counted in Statistics::fallbacks_invalid.");
}

TEST(FallbackLog, ByDefault_ALineOnTheErrorStream_AndNoneIfNobodyIsToBeTold) {
  btConvexHullShape empty;
  btSphereShape sphere(btScalar(0.5));
  for (const bool is_silent : {false, true}) {
    dgd_bullet::Options options;
    if (is_silent) options.on_first_fallback = nullptr;
    Dispatching dispatching(Route::kConfiguration, options);
    PairQuery pair(dispatching.dispatcher(), empty, sphere);
    testing::internal::CaptureStderr();
    for (int step = 0; step < 3; ++step) pair.Step();
    const std::string printed = testing::internal::GetCapturedStderr();
    if (is_silent) {
      EXPECT_EQ(printed, "");
    } else {
      EXPECT_EQ(printed.find("dgd_bullet: a pair of CONVEX_HULL and SPHERE"), 0U) << printed;
      EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 1);
    }
    EXPECT_EQ(dispatching.statistics().fallbacks_invalid, 3U);
  }
}

}  // namespace
}  // namespace dgd_test
