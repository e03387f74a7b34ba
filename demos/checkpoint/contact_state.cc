#include "checkpoint/contact_state.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <cstdint>
#include <vector>

namespace dgd_demos {
namespace {

struct PairState {
  int first, second;   // Indices of the objects in the world.
  bool has_algorithm;  // False: its bodies have been asleep since their bounding boxes overlapped.
};

int IndexOf(const btBroadphaseProxy& proxy) {
  return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getWorldArrayIndex();
}

std::vector<PairState> Describe(const btBroadphasePairArray& pairs) {
  std::vector<PairState> states;
  for (int i = 0; i < pairs.size(); ++i) {
    states.push_back({IndexOf(*pairs[i].m_pProxy0), IndexOf(*pairs[i].m_pProxy1), pairs[i].m_algorithm != nullptr});
  }
  return states;
}

void Check(const StateArchive& archive, const std::vector<PairState>& states, int objects) {
  const auto is_index = [&](int index) { return 0 <= index && index < objects; };
  for (const PairState& state : states) {
    archive.Require(is_index(state.first) && is_index(state.second), "the index of a pair's body is out of range");
    archive.Require(state.first != state.second, "a body has a pair with itself");
  }
}

void Rebuild(const StateArchive& archive, const std::vector<PairState>& states, btCollisionWorld& world) {
  btOverlappingPairCache& cache = *world.getPairCache();
  auto& dispatcher = static_cast<btCollisionDispatcher&>(*world.getDispatcher());
  btBroadphasePairArray& pairs = cache.getOverlappingPairArray();
  while (pairs.size() > 0) cache.removeOverlappingPair(pairs[0].m_pProxy0, pairs[0].m_pProxy1, &dispatcher);

  const auto proxy_of = [&](int index) { return world.getCollisionObjectArray().at(index)->getBroadphaseHandle(); };
  for (const PairState& state : states) cache.addOverlappingPair(proxy_of(state.first), proxy_of(state.second));
  archive.Require(static_cast<std::size_t>(pairs.size()) == states.size(),
                  "a pair is there twice, or of bodies that do not collide");
  for (int i = 0; i < pairs.size(); ++i) {
    if (states[static_cast<std::size_t>(i)].has_algorithm) {
      dispatcher.getNearCallback()(pairs[i], dispatcher, world.getDispatchInfo());
    }
  }
}

// In the order of the pairs; those of one pair in its algorithm's order.
std::vector<btPersistentManifold*> ManifoldsByPair(const btBroadphasePairArray& pairs) {
  std::vector<btPersistentManifold*> manifolds;
  for (int i = 0; i < pairs.size(); ++i) {
    if (pairs[i].m_algorithm == nullptr) continue;
    btManifoldArray of_pair;
    pairs[i].m_algorithm->getAllContactManifolds(of_pair);
    for (int m = 0; m < of_pair.size(); ++m) manifolds.push_back(of_pair[m]);
  }
  return manifolds;
}

void SerializeManifold(StateArchive& archive, btPersistentManifold& manifold) {
  int count = manifold.getNumContacts();
  archive.Serialize(count);
  archive.Require(0 <= count && count <= MANIFOLD_CACHE_SIZE, "a number of contact points is out of range");
  if (archive.is_reading()) manifold.setNumContacts(count);
  for (int i = 0; i < count; ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    archive.SerializePlain(point);
    point.m_userPersistentData = nullptr;  // Nobody sets it here.
  }
  archive.Serialize(manifold.m_companionIdA);
  archive.Serialize(manifold.m_companionIdB);
}

// The places of the manifolds in the dispatcher's list, whose order is that in which the solver takes them.
void SerializePlaces(StateArchive& archive, const std::vector<btPersistentManifold*>& manifolds,
                     btPersistentManifold** list) {
  std::vector<int> places;
  for (const btPersistentManifold* manifold : manifolds) places.push_back(manifold->m_index1a);
  for (int& place : places) archive.Serialize(place);
  if (!archive.is_reading()) return;
  std::vector<bool> is_taken(places.size());
  for (const int place : places) {
    const auto index = static_cast<std::size_t>(place);  // Of a negative one, beyond all.
    archive.Require(index < places.size() && !is_taken[index], "a manifold's place in the solver's order cannot be");
    is_taken[index] = true;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    manifolds[i]->m_index1a = places[i];
    list[places[i]] = manifolds[i];
  }
}

}  // namespace

void SerializeContacts(StateArchive& archive, btCollisionWorld& world) {
  btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
  std::vector<PairState> states;
  if (!archive.is_reading()) states = Describe(pairs);
  archive.Serialize(states, [&](PairState& state) {
    archive.Serialize(state.first);
    archive.Serialize(state.second);
    archive.Serialize(state.has_algorithm);
  });
  if (archive.is_reading()) {
    Check(archive, states, world.getNumCollisionObjects());
    Rebuild(archive, states, world);
  }

  const std::vector<btPersistentManifold*> manifolds = ManifoldsByPair(pairs);
  archive.Expect(manifolds.size(), "contact manifolds of pairs");
  archive.Expect(static_cast<std::uint64_t>(world.getDispatcher()->getNumManifolds()), "contact manifolds");
  for (btPersistentManifold* manifold : manifolds) SerializeManifold(archive, *manifold);
  SerializePlaces(archive, manifolds, world.getDispatcher()->getInternalManifoldPointer());
}

}  // namespace dgd_demos
