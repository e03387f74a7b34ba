// Pairs are visited in nearly the same order in each step, and in a world of thousands no cache holds them all: what
// came after a pair in the last step can be prefetched while this one is solved. Bullet's call, which begins with the
// pair's virtual table, had waited for 5 % of the whole step of a heap of 3000 boxes (perf). To prefetch more than one
// pair ahead brings no more, and what the pair points to, or its two bodies, less than 5 % of the narrowphase.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The addresses that one thread has visited last.
class VisitingOrder {
 public:
  /// Number of a visit; what is visited stores its last one, and 0 before.
  using Place = std::uint32_t;

  /// Largest number of visits in a step for which the last step's order is available.
  static constexpr std::size_t kPlaces = std::size_t{1} << 16;

  /// The order stays unknown without memory for it.
  VisitingOrder() : visits_(static_cast<const void**>(std::calloc(kPlaces, sizeof(void*)))), now_(FirstPlace()) {}

  /// Notes a visit.
  /// @param place  In and out: place of the last visit of the same, on any thread.
  /// @return the address that was visited next after that last visit, where nothing may be any more; null if that is
  ///         unknown.
  const void* Visit(const void* visited, Place& place) {
    if (visits_ == nullptr) return nullptr;
    // The last visit of all has no next one, old ones have been overwritten, and others are of another thread, mostly.
    const bool is_known = now_ - place >= 2 && now_ - place < kPlaces;
    const void* next = is_known ? visits_[(place + 1) % kPlaces] : nullptr;
    DGD_ASSERT(visited != nullptr);
    visits_[now_ % kPlaces] = visited;
    place = now_++;
    return next;
  }

  static VisitingOrder& OfThisThread() {
    static thread_local VisitingOrder order;
    return order;
  }

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };

  /// Each thread counts from elsewhere, so that the places of one are not taken for another's.
  static Place FirstPlace() {
    static std::atomic<Place> threads{1};
    constexpr Place kGolden = 0x9e3779b9;  // Its multiples are spread evenly.
    return threads.fetch_add(1, std::memory_order_relaxed) * kGolden;
  }

  std::unique_ptr<const void*[], Free> visits_;  // Pages of calloc() cost nothing until they are visited.
  Place now_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
