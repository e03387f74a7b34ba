#include "bench/threaded_dispatcher.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>

namespace dgd_bench {
namespace {

bool IsConvex(const btBroadphaseProxy* proxy) {
  return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getCollisionShape()->isConvex();
}

}  // namespace

ThreadedDispatcher::ThreadedDispatcher(btCollisionConfiguration* configuration, int threads)
    : TimingDispatcher(configuration), start_(threads), end_(threads) {
  for (int helper = 1; helper < threads; ++helper) {
    helpers_.emplace_back([this] {
      for (;;) {
        start_.arrive_and_wait();
        if (is_over_) return;
        Work();
        end_.arrive_and_wait();
      }
    });
  }
}

ThreadedDispatcher::~ThreadedDispatcher() {
  is_over_ = true;
  start_.arrive_and_wait();
}

void ThreadedDispatcher::Dispatch(btOverlappingPairCache* pair_cache, const btDispatcherInfo& info,
                                  btDispatcher* dispatcher) {
  if (helpers_.empty()) {
    TimingDispatcher::Dispatch(pair_cache, info, dispatcher);
    return;
  }
  btBroadphasePairArray& pairs = pair_cache->getOverlappingPairArray();
  shared_.clear();
  for (int i = 0; i < pairs.size(); ++i) {
    btBroadphasePair& pair = pairs[i];
    if (pair.m_algorithm != nullptr && IsConvex(pair.m_pProxy0) && IsConvex(pair.m_pProxy1)) {
      shared_.push_back(&pair);
    } else {
      getNearCallback()(pair, *this, info);
    }
  }
  info_ = &info;
  next_ = 0;
  start_.arrive_and_wait();
  Work();
  end_.arrive_and_wait();
}

void ThreadedDispatcher::Work() {
  constexpr std::size_t kChunk = 64;  // Pairs: some tens of microseconds.
  for (std::size_t first = next_.fetch_add(kChunk); first < shared_.size(); first = next_.fetch_add(kChunk)) {
    const std::size_t last = std::min(first + kChunk, shared_.size());
    for (std::size_t i = first; i < last; ++i) getNearCallback()(*shared_[i], *this, *info_);
  }
}

}  // namespace dgd_bench
