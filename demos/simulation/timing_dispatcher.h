// Bullet's dispatcher with a stop watch, a counter and, if wanted, an observer: the same for every narrowphase, and
// outside of what it measures.
#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <dgd_bullet/options.h>

#include <chrono>

namespace dgd_demos {

/// What the last dispatch of all pairs took.
class DispatchCost {
 public:
  /// Wall time.
  std::chrono::duration<double, std::micro> last_duration() const { return last_duration_; }
  /// Pairs that were handed to an algorithm. Bullet skips pairs of which both bodies sleep.
  int last_queries() const { return last_queries_; }

 protected:
  std::chrono::duration<double, std::micro> last_duration_{};
  int last_queries_ = 0;
};

/// @tparam Dispatcher  btCollisionDispatcher, or one that derives from it.
template <class Dispatcher>
class TimingDispatcherOf : public Dispatcher, public DispatchCost {
 public:
  using Dispatcher::Dispatcher;

  void dispatchAllCollisionPairs(btOverlappingPairCache* pair_cache, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override {
    if (observer_ != nullptr) ShowQueries(pair_cache->getOverlappingPairArray());
    const auto start = std::chrono::steady_clock::now();
    Dispatcher::dispatchAllCollisionPairs(pair_cache, info, dispatcher);
    last_duration_ = std::chrono::steady_clock::now() - start;
    last_queries_ = CountQueries(pair_cache->getOverlappingPairArray());
  }

  /// Shows an observer, which must outlive this, the queries of each dispatch from now on.
  void ShowQueriesTo(dgd_bullet::PairObserver& observer) { observer_ = &observer; }

 private:
  int CountQueries(const btBroadphasePairArray& pairs) {
    int queries = 0;
    ForEachQuery(pairs, [&](const btCollisionObject&, const btCollisionObject&) { ++queries; });
    return queries;
  }

  void ShowQueries(const btBroadphasePairArray& pairs) {
    const auto wrap = [](const btCollisionObject& body) {
      return btCollisionObjectWrapper(nullptr, body.getCollisionShape(), &body, body.getWorldTransform(), -1, -1);
    };
    ForEachQuery(pairs, [&](const btCollisionObject& first, const btCollisionObject& second) {
      if (first.getCollisionShape()->isConvex() && second.getCollisionShape()->isConvex()) {
        observer_->OnPair(wrap(first), wrap(second));
      }
    });
  }

  template <class Use>
  void ForEachQuery(const btBroadphasePairArray& pairs, const Use& use) {
    for (int i = 0; i < pairs.size(); ++i) {
      const auto* first = static_cast<const btCollisionObject*>(pairs[i].m_pProxy0->m_clientObject);
      const auto* second = static_cast<const btCollisionObject*>(pairs[i].m_pProxy1->m_clientObject);
      if (this->needsCollision(first, second)) use(*first, *second);
    }
  }

  dgd_bullet::PairObserver* observer_ = nullptr;
};

using TimingDispatcher = TimingDispatcherOf<btCollisionDispatcher>;

}  // namespace dgd_demos
