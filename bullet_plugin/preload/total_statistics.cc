#include "total_statistics.h"

#include <algorithm>
#include <utility>

namespace dgd_preload {
namespace {

using dgd_bullet::FallbackCounts;
using dgd_bullet::PairStatistics;
using dgd_bullet::Statistics;

void AddFallbacks(const FallbackCounts& counts, FallbackCounts& total) {
  total.fallbacks_not_converged += counts.fallbacks_not_converged;
  total.fallbacks_no_interior += counts.fallbacks_no_interior;
  total.fallbacks_invalid += counts.fallbacks_invalid;
  total.fallbacks_no_memory += counts.fallbacks_no_memory;
}

template <class Counts>
void AddEach(const Counts& counts, Counts& total) {
  for (std::size_t i = 0; i < counts.size(); ++i) total[i] += counts[i];
}

void AddPair(const PairStatistics& pair, PairStatistics& total) {
  AddFallbacks(pair, total);
  total.calls += pair.calls;
  total.separated += pair.separated;
  total.resting += pair.resting;
  total.deep += pair.deep;
  total.solved += pair.solved;
  total.worst_gap = std::max(total.worst_gap, pair.worst_gap);
  AddEach(pair.iterations, total.iterations);
  AddEach(pair.patch_sizes, total.patch_sizes);
}

}  // namespace

void Add(const Statistics& statistics, Statistics& total) {
  AddFallbacks(statistics, total);
  const auto types = [](const PairStatistics& pair) { return std::pair(pair.type_0, pair.type_1); };
  for (const PairStatistics& pair : statistics.pairs) {
    const auto place = std::ranges::lower_bound(total.pairs, types(pair), {}, types);
    if (place == total.pairs.end() || types(*place) != types(pair)) {
      total.pairs.insert(place, pair);
    } else {
      AddPair(pair, *place);
    }
  }
}

}  // namespace dgd_preload
