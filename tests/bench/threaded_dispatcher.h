// Bullet's dispatcher with its pairs shared among threads, for a Bullet that is built without BT_THREADSAFE, as
// Debian's is: there btCollisionDispatcherMt has one thread, and nothing but a pair's own algorithm may run beside
// others.
#pragma once

#include <atomic>
#include <barrier>
#include <thread>
#include <vector>

#include "simulation/timing_dispatcher.h"

namespace dgd_bench {

class ThreadedDispatcher : public dgd_demos::TimingDispatcher {
 public:
  /// @param threads  >= 1, the caller's among them.
  ThreadedDispatcher(btCollisionConfiguration* configuration, int threads);
  ~ThreadedDispatcher() override;

 protected:
  /// Pairs that have their algorithm and are convex are shared. Before them, in their order, come those that take
  /// memory from Bullet's pools: new ones, and what makes algorithms for its children.
  void Dispatch(btOverlappingPairCache* pair_cache, const btDispatcherInfo& info, btDispatcher* dispatcher) override;

 private:
  void Work();

  std::vector<btBroadphasePair*> shared_;
  const btDispatcherInfo* info_ = nullptr;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> is_over_{false};
  std::barrier<> start_, end_;
  std::vector<std::jthread> helpers_;
};

}  // namespace dgd_bench
