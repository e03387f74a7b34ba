// What PairStatistics reports, counted by all threads at once.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "algorithms/fallback.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/statistics.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// How one call ended.
struct PairOutcome {
  enum class Way { kSeparated, kResting, kFollowed, kSolved };

  Way way = Way::kSolved;
  int iterations = 0;
  double gap = 0;  ///< Of what was solved.
  int patch_size = 0;
};

/// Each number is counted for itself, relaxed: nothing is inferred from two of them while they are counted.
class PairCounters {
 public:
  PairCounters();

  void Count(int type_0, int type_1, const PairOutcome& outcome);
  void CountFallback(int type_0, int type_1, Fallback fallback);

  /// Of the types that met.
  std::vector<PairStatistics> Read() const;

 private:
  using Counter = std::atomic<std::uint64_t>;
  struct Row {
    Counter separated{0}, resting{0}, followed{0}, solved{0};
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
