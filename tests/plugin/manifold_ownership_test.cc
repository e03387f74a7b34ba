// Who owns the contact manifold of a pair, when it is made and released, and the memory of the algorithm itself.
#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <LinearMath/btPoolAllocator.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

const btTransform kTouchingPose = MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.99});
const btTransform kFarPose = MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 5});

/// Has no manifold to give while `exhausted`, as one whose pool is full and may not grow; counts what goes in and out.
class CountingDispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override {
    if (exhausted) return nullptr;
    ++made;
    return btCollisionDispatcher::getNewManifold(a, b);
  }
  void releaseManifold(btPersistentManifold* manifold) override {
    ++released;
    btCollisionDispatcher::releaseManifold(manifold);
  }
  void* allocateCollisionAlgorithm(int size) override {
    sizes.push_back(size);
    void* memory = btCollisionDispatcher::allocateCollisionAlgorithm(size);
    addresses.push_back(memory);
    return memory;
  }

  bool exhausted = false;
  int made = 0, released = 0;
  std::vector<int> sizes;
  std::vector<void*> addresses;
};

class ManifoldOwnership : public testing::Test {
 protected:
  dgd_bullet::CollisionConfiguration configuration_;
  CountingDispatcher dispatcher_{&configuration_};
  btBoxShape box_{Vec(0.5, 0.5, 0.5)};
};

// The island manager, ghost objects and character controllers look at empty manifolds too.
TEST_F(ManifoldOwnership, OwnManifold_IsMadeAtTheFirstCallAlsoWithoutContact) {
  PairQuery pair(dispatcher_, box_, box_);
  pair.SetPoses(kFarPose, btTransform::getIdentity());
  EXPECT_TRUE(pair.Step().empty());
  EXPECT_EQ(dispatcher_.made, 1);
  EXPECT_EQ(dispatcher_.getNumManifolds(), 1);
  ASSERT_NE(pair.manifold(), nullptr);
  EXPECT_EQ(pair.manifold()->getNumContacts(), 0);
  EXPECT_EQ(pair.manifold()->getBody0(), &pair.body_a());
  EXPECT_EQ(pair.manifold()->getBody1(), &pair.body_b());
  pair.Step();
  EXPECT_EQ(dispatcher_.made, 1) << "one manifold for the life of the pair";
}

TEST_F(ManifoldOwnership, OwnManifold_IsListedOnceAndOnlyOnceItExists) {
  PairQuery pair(dispatcher_, box_, box_);
  const btCollisionObjectWrapper a(nullptr, &box_, &pair.body_a(), pair.body_a().getWorldTransform(), -1, -1);
  btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(&a, &a, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  btManifoldArray manifolds;
  algorithm->getAllContactManifolds(manifolds);
  EXPECT_EQ(manifolds.size(), 0);
  algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm);
  EXPECT_EQ(dispatcher_.released, 0);

  pair.Step();
  pair.algorithm()->getAllContactManifolds(manifolds);
  ASSERT_EQ(manifolds.size(), 1);
  EXPECT_EQ(manifolds[0], dispatcher_.getManifoldByIndexInternal(0));
}

TEST_F(ManifoldOwnership, OwnManifold_IsReleasedWithThePair) {
  {
    PairQuery pair(dispatcher_, box_, box_);
    pair.SetPoses(kTouchingPose, btTransform::getIdentity());
    pair.Step();
    EXPECT_EQ(dispatcher_.getNumManifolds(), 1);
    EXPECT_EQ(dispatcher_.released, 0);
  }
  EXPECT_EQ(dispatcher_.released, 1);
  EXPECT_EQ(dispatcher_.getNumManifolds(), 0);
}

TEST_F(ManifoldOwnership, OwnManifold_IsRefreshed) {
  PairQuery pair(dispatcher_, box_, box_);
  pair.SetPoses(kTouchingPose, btTransform::getIdentity());
  pair.Step();
  pair.Step();
  ASSERT_EQ(pair.manifold()->getNumContacts(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(pair.manifold()->getContactPoint(i).getLifeTime(), 2);
}

TEST_F(ManifoldOwnership, SharedManifold_IsUsedButNotListedNorReleased) {
  PairQuery pair(dispatcher_, box_, box_);
  pair.SetPoses(kTouchingPose, btTransform::getIdentity());
  btPersistentManifold* shared = dispatcher_.getNewManifold(&pair.body_a(), &pair.body_b());
  const int made = dispatcher_.made;
  EXPECT_EQ(pair.Step(shared).size(), 4U);
  EXPECT_EQ(dispatcher_.made, made);
  EXPECT_EQ(shared->getNumContacts(), 4);
  EXPECT_EQ(pair.manifold(), nullptr);
  pair.Forget();
  EXPECT_EQ(dispatcher_.released, 0);
  EXPECT_EQ(dispatcher_.getNumManifolds(), 1);
  EXPECT_EQ(shared->getNumContacts(), 4);
  dispatcher_.releaseManifold(shared);
}

// A mesh refreshes it once after all its triangles; each triangle must leave the others' points alone.
TEST_F(ManifoldOwnership, SharedManifold_IsNotRefreshedAndKeepsOtherPairsPoints) {
  PairQuery pair(dispatcher_, box_, box_);
  btPersistentManifold* shared = dispatcher_.getNewManifold(&pair.body_a(), &pair.body_b());
  btManifoldPoint others(Vec(9, 9, 9), Vec(9, 9, 9), Vec(0, 0, 1), btScalar(-0.5));
  shared->addManifoldPoint(others);
  // Apart, then touching: neither may drop or age it, though it is far from where the boxes are.
  for (const btTransform& pose : {kFarPose, kTouchingPose}) {
    pair.SetPoses(pose, btTransform::getIdentity());
    pair.Step(shared);
    bool found = false;
    for (int i = 0; i < shared->getNumContacts(); ++i) {
      const btManifoldPoint& point = shared->getContactPoint(i);
      found = found || (point.m_localPointA == Vec(9, 9, 9) && point.getLifeTime() == 0);
    }
    EXPECT_TRUE(found);
  }
  pair.Forget();
  dispatcher_.releaseManifold(shared);
}

TEST_F(ManifoldOwnership, NoManifoldLeft_ReturnsQuietlyAndTriesAgain) {
  PairQuery pair(dispatcher_, box_, box_);
  pair.SetPoses(kTouchingPose, btTransform::getIdentity());
  dispatcher_.exhausted = true;
  EXPECT_TRUE(pair.Step().empty());
  EXPECT_EQ(pair.manifold(), nullptr);
  dispatcher_.exhausted = false;
  EXPECT_EQ(pair.Step().size(), 4U);
  EXPECT_NE(pair.manifold(), nullptr);

  PairQuery never(dispatcher_, box_, box_);
  never.SetPoses(kTouchingPose, btTransform::getIdentity());
  dispatcher_.exhausted = true;
  EXPECT_TRUE(never.Step().empty());
  const int released = dispatcher_.released;
  never.Forget();
  EXPECT_EQ(dispatcher_.released, released) << "there was nothing to release";
}

// The same in Bullet's own way: a full pool that may not grow.
TEST(ManifoldPool, Full_ReturnsQuietly) {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  dgd_bullet::CollisionConfiguration configuration({}, info);
  btCollisionDispatcher dispatcher(&configuration);
  dispatcher.setDispatcherFlags(dispatcher.getDispatcherFlags() |
                                btCollisionDispatcher::CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery first(dispatcher, box, box), second(dispatcher, box, box);
  for (PairQuery* pair : {&first, &second}) pair->SetPoses(kTouchingPose, btTransform::getIdentity());
  EXPECT_EQ(first.Step().size(), 4U);
  EXPECT_TRUE(second.Step().empty());
  first.Forget();
  EXPECT_EQ(second.Step().size(), 4U);
}

// Bullet's pools do not look at the size that is asked for: 184 bytes is the largest algorithm of Bullet's own, so that
// much is in every pool that works.
TEST_F(ManifoldOwnership, Algorithm_FitsEveryPoolThatFitsBullets) {
  constexpr int kLargestOfBullets = 184;
  PairQuery pair(dispatcher_, box_, box_);
  pair.Step();
  ASSERT_EQ(dispatcher_.sizes.size(), 1U);
  EXPECT_LE(dispatcher_.sizes[0], kLargestOfBullets);
  EXPECT_LE(dispatcher_.sizes[0], configuration_.getCollisionAlgorithmPool()->getElementSize());
  EXPECT_EQ(pair.algorithm(), dispatcher_.addresses[0]);
  EXPECT_TRUE(configuration_.getCollisionAlgorithmPool()->validPtr(pair.algorithm()));
}

/// The element sizes of the pool: Bullet's largest algorithm and no byte more, the default configuration's, and the
/// soft-body configuration's in both precisions, whose odd elements are aligned to 8 bytes only.
class AlgorithmPool : public testing::TestWithParam<int> {};

TEST_P(AlgorithmPool, NeighboursDoNotOverrunEachOther) {
  constexpr int kPairs = 20;
  btPoolAllocator pool(GetParam(), kPairs);
  btDefaultCollisionConstructionInfo info;
  info.m_collisionAlgorithmPool = &pool;
  dgd_bullet::CollisionConfiguration configuration({}, info);
  btCollisionDispatcher dispatcher(&configuration);
  btConvexHullShape hull;
  for (int i = 0; i < 8; ++i) hull.addPoint(Vec(i & 1, i >> 1 & 1, i >> 2 & 1));
  std::vector<std::unique_ptr<PairQuery>> pairs;
  std::vector<std::vector<Contact>> first;
  for (int i = 0; i < kPairs; ++i) {
    pairs.push_back(std::make_unique<PairQuery>(dispatcher, hull, hull));
    pairs.back()->SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0.1, 0.01 * i, 1.05}),
                           btTransform::getIdentity());
    first.push_back(pairs.back()->Step());
    EXPECT_FALSE(first.back().empty());
  }
  EXPECT_EQ(pool.getFreeCount(), 0);
  bool any_odd = false;
  for (int i = 0; i < kPairs; ++i) {
    PairQuery& pair = *pairs[static_cast<std::size_t>(i)];
    any_odd = any_odd || reinterpret_cast<std::uintptr_t>(pair.algorithm()) % 16 != 0;
    const std::vector<Contact> again = pair.Step();
    ASSERT_EQ(again.size(), first[static_cast<std::size_t>(i)].size());
    EXPECT_NEAR(Deepest(again).depth, Deepest(first[static_cast<std::size_t>(i)]).depth, 1e-6);
  }
  EXPECT_EQ(any_odd, GetParam() % 16 != 0);
  // The pool is full: the next one comes from the heap, and goes back there.
  PairQuery extra(dispatcher, hull, hull);
  EXPECT_FALSE(extra.Step().empty());
  EXPECT_FALSE(pool.validPtr(extra.algorithm()));
  extra.Forget();
  pairs.clear();
  EXPECT_EQ(pool.getFreeCount(), kPairs);
  EXPECT_EQ(dispatcher.getNumManifolds(), 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, AlgorithmPool, testing::Values(184, 192, 248, 280), testing::PrintToStringParamName());

// A new pair takes the slot of one that is gone, and nothing of its state: other shapes, other hull, other normal.
TEST_F(ManifoldOwnership, Slot_IsReusedWithoutItsPast) {
  btConvexHullShape hull;
  for (int i = 0; i < 8; ++i) hull.addPoint(Vec(i & 1, i >> 1 & 1, i >> 2 & 1));
  btSphereShape sphere(btScalar(0.5));
  void* slot = nullptr;
  {
    PairQuery first(dispatcher_, hull, hull);
    first.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 1.05}), btTransform::getIdentity());
    first.Step();
    slot = first.algorithm();
  }
  PairQuery second(dispatcher_, sphere, box_);
  second.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), {0.99, 0, 0}), btTransform::getIdentity());
  const std::vector<Contact> contacts = second.Step();
  EXPECT_EQ(second.algorithm(), slot);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].depth, -0.01, 1e-6);
  EXPECT_NEAR(contacts[0].normal_b_to_a.x(), 1, 1e-6);
  EXPECT_EQ(second.manifold()->getNumContacts(), 1);
}

// A continuous dispatch asks for the time of impact; "none" is a legal answer, an assertion is not.
TEST_F(ManifoldOwnership, TimeOfImpact_IsAFractionOfTheStep) {
  PairQuery pair(dispatcher_, box_, box_);
  pair.SetPoses(kFarPose, btTransform::getIdentity());
  pair.Step();
  btManifoldResult result;
  const btScalar fraction =
      pair.algorithm()->calculateTimeOfImpact(&pair.body_a(), &pair.body_b(), btDispatcherInfo(), &result);
  EXPECT_GE(fraction, 0);
  EXPECT_LE(fraction, 1);
}

// In a world: the overlapping pair's end releases the manifold.
TEST(ManifoldLife, FollowsTheBroadphasePair) {
  TestWorld world(Route::kConfiguration);
  auto& box = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  world.AddGround();
  btRigidBody& body = world.Add(box, 1, Vec(0, 0, 0.5));
  world.Detect();
  EXPECT_EQ(world.dispatcher().getNumManifolds(), 1);
  EXPECT_EQ(world.Points().size(), 4U);
  body.setCenterOfMassTransform(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 10}));
  world.Detect();
  EXPECT_EQ(world.dispatcher().getNumManifolds(), 0);
  body.setCenterOfMassTransform(MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.5}));
  world.Detect();
  EXPECT_EQ(world.Points().size(), 4U);
}

}  // namespace
}  // namespace dgd_test
