#include "algorithms/visiting_order.h"

#include <atomic>
#include <new>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Each thread counts from elsewhere, so that the places of one are not taken for another's.
VisitingOrder::Place FirstPlace() {
  static std::atomic<VisitingOrder::Place> threads{1};
  constexpr VisitingOrder::Place kGolden = 0x9e3779b9;  // Its multiples are spread evenly.
  return threads.fetch_add(1, std::memory_order_relaxed) * kGolden;
}

}  // namespace

VisitingOrder::VisitingOrder() : visits_(new (std::nothrow) Visits()), now_(FirstPlace()) {}

VisitingOrder& VisitingOrder::OfThisThread() {
  static thread_local VisitingOrder order;
  return order;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
