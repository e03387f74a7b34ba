// Contract: a broadphase that reads the state of another one finds the same pairs from then on, in the same order.
#include "checkpoint/broadphase_state.h"

#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "checkpoint/contact_state.h"
#include "support/random.h"

namespace dgd_demos {
namespace {

using PairOrder = std::vector<std::pair<int, int>>;

// Spheres on circles of different sizes and speeds, so that pairs come and go.
class CrowdedWorld {
 public:
  CrowdedWorld() {
    dgd_test::Random random(7);
    for (int i = 0; i < kBodies; ++i) {
      Orbit orbit;
      orbit.centre = btVector3(btScalar(random.Uniform(-2, 2)), btScalar(random.Uniform(-2, 2)), 0);
      orbit.radius = random.Uniform(0.1, 2);
      orbit.speed = random.Uniform(-3, 3);
      orbits_.push_back(orbit);
      objects_.emplace_back();
      objects_.back().setCollisionShape(&sphere_);
    }
    MoveTo(0);
    for (btCollisionObject& object : objects_) world_.addCollisionObject(&object);
  }
  ~CrowdedWorld() {
    for (btCollisionObject& object : objects_) world_.removeCollisionObject(&object);
  }

  void MoveTo(double time) {
    for (int i = 0; i < kBodies; ++i) {
      const Orbit& orbit = orbits_[static_cast<std::size_t>(i)];
      const double angle = orbit.speed * time;
      objects_[static_cast<std::size_t>(i)].getWorldTransform().setOrigin(
          orbit.centre +
          btVector3(btScalar(orbit.radius * std::cos(angle)), btScalar(orbit.radius * std::sin(angle)), 0));
    }
  }

  PairOrder DetectAt(double time) {
    MoveTo(time);
    world_.performDiscreteCollisionDetection();
    PairOrder order;
    const btBroadphasePairArray& pairs = world_.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
      order.emplace_back(pairs[i].m_pProxy0->m_uniqueId, pairs[i].m_pProxy1->m_uniqueId);
    }
    return order;
  }

  /// The objects in the order of the tree's leaves.
  std::vector<int> LeafOrder() const {
    std::vector<int> order;
    AddLeaves(broadphase_.m_sets[0].m_root, order);
    return order;
  }

  void Serialize(StateArchive& archive) {
    SerializeBroadphase(archive, broadphase_, world_.getCollisionObjectArray());
    SerializeContacts(archive, world_);
  }

 private:
  static constexpr int kBodies = 150;
  struct Orbit {
    btVector3 centre;
    double radius, speed;  // m, rad/s
  };

  static void AddLeaves(const btDbvtNode* node, std::vector<int>& order) {
    if (node->isleaf()) {
      order.push_back(static_cast<const btDbvtProxy*>(node->data)->m_uniqueId);
    } else {
      AddLeaves(node->childs[0], order);
      AddLeaves(node->childs[1], order);
    }
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  btSphereShape sphere_{btScalar(0.15)};
  std::vector<Orbit> orbits_;
  std::deque<btCollisionObject> objects_;
};

TEST(BroadphaseStateTest, Read_FindsTheSamePairsInTheSameOrder) {
  constexpr int kSteps = 400, kCheckpoint = 150;
  const auto time_of = [](int step) { return 0.02 * step; };
  CrowdedWorld world;
  for (int step = 0; step <= kCheckpoint; ++step) world.DetectAt(time_of(step));
  StateArchive written;
  world.Serialize(written);

  CrowdedWorld again;
  again.MoveTo(time_of(kCheckpoint));
  StateArchive archive(written.bytes(), "state");
  again.Serialize(archive);
  archive.ExpectEnd();
  for (int step = kCheckpoint + 1; step <= kSteps; ++step) {
    const PairOrder order = world.DetectAt(time_of(step));
    ASSERT_GT(order.size(), 100U);
    ASSERT_EQ(again.DetectAt(time_of(step)), order) << "step " << step;
    ASSERT_EQ(again.LeafOrder(), world.LeafOrder()) << "step " << step;
  }
}

}  // namespace
}  // namespace dgd_demos
