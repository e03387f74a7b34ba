// What PairStatistics reports, counted by all threads at once.
#pragma once

#include <mutex>
#include <vector>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/statistics.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairCounters {
 public:
  PairCounters();

  /// @param outcome  One without a fallback.
  void Count(int type_0, int type_1, const PairOutcome& outcome);
  void CountFallback(int type_0, int type_1, Fallback fallback);

  /// The counts of the types that met.
  std::vector<PairStatistics> Read() const;

 private:
  PairStatistics& RowOf(int type_0, int type_1);

  mutable std::mutex mutex_;
  std::vector<PairStatistics> rows_;  // A table of all pairs of types.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
