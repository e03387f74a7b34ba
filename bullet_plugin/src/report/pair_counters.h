// What PairStatistics reports, counted by all threads at once.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/statistics.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Each number is counted on its own, relaxed: nothing is inferred from two of them while they are counted.
class PairCounters {
 public:
  PairCounters();

  /// @param outcome  One without a fallback.
  void Count(int type_0, int type_1, const PairOutcome& outcome);
  void CountFallback(int type_0, int type_1, Fallback fallback);

  /// The counts of the types that met.
  std::vector<PairStatistics> Read() const;

 private:
  using Counter = std::atomic<std::uint64_t>;
  struct Row {
    Counter separated{0}, recycled{0}, solved{0}, deep{0};
    std::array<Counter, kFallbacks> fallbacks{};
    std::array<Counter, PairStatistics::kMaxIterations + 1> iterations{};
    std::array<Counter, 5> patch_sizes{};
    std::atomic<double> worst_gap{0};
  };

  Row& RowOf(int type_0, int type_1);

  std::vector<Row> rows_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
