#include "report/pair_counters.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <algorithm>
#include <iterator>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

constexpr int kTypes = STATIC_PLANE_PROXYTYPE + 1;

}  // namespace

PairCounters::PairCounters() : rows_(std::size_t(kTypes) * kTypes) {}

PairStatistics& PairCounters::RowOf(int type_0, int type_1) {
  const auto [lower, higher] = std::minmax(type_0, type_1);
  DGD_ASSERT(lower >= 0 && higher < kTypes);
  PairStatistics& row = rows_[static_cast<std::size_t>(lower * kTypes + higher)];
  row.type_0 = lower;
  row.type_1 = higher;
  ++row.calls;
  return row;
}

void PairCounters::Count(int type_0, int type_1, const PairOutcome& outcome) {
  DGD_ASSERT(!outcome.fallback && outcome.iterations >= 0 && outcome.patch_size <= 4);
  const std::lock_guard lock(mutex_);
  PairStatistics& row = RowOf(type_0, type_1);
  switch (outcome.stage) {
    case PairOutcome::Stage::kSeparated:
      ++row.separated;
      break;
    case PairOutcome::Stage::kRecycled:
      ++row.resting;
      break;
    case PairOutcome::Stage::kDeep:
      ++row.deep;
      [[fallthrough]];
    case PairOutcome::Stage::kSolved:
      ++row.solved;
      row.worst_gap = std::max(row.worst_gap, outcome.gap);
      break;
  }
  ++row.iterations[std::min(static_cast<std::size_t>(outcome.iterations), PairStatistics::kMaxIterations)];
  ++row.patch_sizes[outcome.patch_size];
}

void PairCounters::CountFallback(int type_0, int type_1, Fallback fallback) {
  const std::lock_guard lock(mutex_);
  ++CountOf(RowOf(type_0, type_1), fallback);
}

std::vector<PairStatistics> PairCounters::Read() const {
  const std::lock_guard lock(mutex_);
  std::vector<PairStatistics> pairs;
  std::ranges::copy_if(rows_, std::back_inserter(pairs), [](const PairStatistics& row) { return row.calls > 0; });
  return pairs;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
