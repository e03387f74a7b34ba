#include "checkpoint/contact_state.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <algorithm>
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

void Rebuild(const std::vector<PairState>& states, btCollisionWorld& world) {
  btOverlappingPairCache& cache = *world.getPairCache();
  auto& dispatcher = static_cast<btCollisionDispatcher&>(*world.getDispatcher());
  btBroadphasePairArray& pairs = cache.getOverlappingPairArray();
  while (pairs.size() > 0) cache.removeOverlappingPair(pairs[0].m_pProxy0, pairs[0].m_pProxy1, &dispatcher);

  const auto proxy_of = [&](int index) { return world.getCollisionObjectArray().at(index)->getBroadphaseHandle(); };
  for (const PairState& state : states) cache.addOverlappingPair(proxy_of(state.first), proxy_of(state.second));
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

void AddManifold(StateArchive& archive, btPersistentManifold& manifold) {
  int count = manifold.getNumContacts();
  archive.Add(count);
  if (archive.is_reading()) manifold.setNumContacts(count);
  for (int i = 0; i < count; ++i) archive.AddPlain(manifold.getContactPoint(i));
  archive.Add(manifold.m_companionIdA);
  archive.Add(manifold.m_companionIdB);
}

// The dispatcher's list, by places in the order of the pairs.
void AddOrder(StateArchive& archive, const std::vector<btPersistentManifold*>& by_pair, btDispatcher& dispatcher) {
  btPersistentManifold** const list = dispatcher.getInternalManifoldPointer();
  for (std::size_t i = 0; i < by_pair.size(); ++i) {
    std::uint64_t place = 0;
    if (!archive.is_reading())
      place = static_cast<std::uint64_t>(std::ranges::find(by_pair, list[i]) - by_pair.begin());
    archive.Add(place);
    if (!archive.is_reading()) continue;
    list[i] = by_pair.at(place);
    list[i]->m_index1a = static_cast<int>(i);
  }
}

}  // namespace

void AddContacts(StateArchive& archive, btCollisionWorld& world) {
  btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
  std::vector<PairState> states;
  if (!archive.is_reading()) states = Describe(pairs);
  archive.Add(states, [&](PairState& state) { archive.Add(state); });
  if (archive.is_reading()) Rebuild(states, world);

  const std::vector<btPersistentManifold*> manifolds = ManifoldsByPair(pairs);
  archive.Expect(manifolds.size(), "contact manifolds of pairs");
  archive.Expect(static_cast<std::uint64_t>(world.getDispatcher()->getNumManifolds()), "contact manifolds");
  for (btPersistentManifold* manifold : manifolds) AddManifold(archive, *manifold);
  AddOrder(archive, manifolds, *world.getDispatcher());
}

}  // namespace dgd_demos
