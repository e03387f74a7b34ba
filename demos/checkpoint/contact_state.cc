#include "checkpoint/contact_state.h"

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

// @param list  the dispatcher's manifolds, in the order in which the solver takes them.
void SerializeManifold(StateArchive& archive, btPersistentManifold& manifold, btPersistentManifold** list) {
  int count = manifold.getNumContacts();
  archive.Serialize(count);
  if (archive.is_reading()) manifold.setNumContacts(count);
  for (int i = 0; i < count; ++i) archive.SerializePlain(manifold.getContactPoint(i));
  archive.Serialize(manifold.m_companionIdA);
  archive.Serialize(manifold.m_companionIdB);
  archive.Serialize(manifold.m_index1a);  // Place in the list.
  list[manifold.m_index1a] = &manifold;
}

}  // namespace

void SerializeContacts(StateArchive& archive, btCollisionWorld& world) {
  btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
  std::vector<PairState> states;
  if (!archive.is_reading()) states = Describe(pairs);
  archive.Serialize(states, [&](PairState& state) { archive.Serialize(state); });
  if (archive.is_reading()) Rebuild(states, world);

  const std::vector<btPersistentManifold*> manifolds = ManifoldsByPair(pairs);
  archive.Expect(manifolds.size(), "contact manifolds of pairs");
  archive.Expect(static_cast<std::uint64_t>(world.getDispatcher()->getNumManifolds()), "contact manifolds");
  btPersistentManifold** const list = world.getDispatcher()->getInternalManifoldPointer();
  for (btPersistentManifold* manifold : manifolds) SerializeManifold(archive, *manifold, list);
}

}  // namespace dgd_demos
