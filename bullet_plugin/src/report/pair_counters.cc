#include "report/pair_counters.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <algorithm>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

constexpr int kTypes = STATIC_PLANE_PROXYTYPE + 1;

/// Index of the row of two types in a table of all.
std::size_t IndexOf(int lower_type, int higher_type) {
  return static_cast<std::size_t>(lower_type) * kTypes + static_cast<std::size_t>(higher_type);
}

void Increment(std::atomic<std::uint64_t>& counter) { counter.fetch_add(1, std::memory_order_relaxed); }

void RaiseTo(double value, std::atomic<double>& largest) {
  double so_far = largest.load(std::memory_order_relaxed);
  while (value > so_far && !largest.compare_exchange_weak(so_far, value, std::memory_order_relaxed)) {
  }
}

}  // namespace

PairCounters::PairCounters() : rows_(std::size_t(kTypes) * kTypes) {}

PairCounters::Row& PairCounters::RowOf(int type_0, int type_1) {
  DGD_ASSERT(std::min(type_0, type_1) >= 0 && std::max(type_0, type_1) < kTypes);
  return rows_[IndexOf(std::min(type_0, type_1), std::max(type_0, type_1))];
}

void PairCounters::Count(int type_0, int type_1, const PairOutcome& outcome) {
  DGD_ASSERT(!outcome.fallback && outcome.iterations >= 0 && outcome.patch_size <= 4);
  Row& row = RowOf(type_0, type_1);
  switch (outcome.stage) {
    case PairOutcome::Stage::kSeparated:
      Increment(row.separated);
      break;
    case PairOutcome::Stage::kRecycled:
      Increment(row.recycled);
      break;
    case PairOutcome::Stage::kDeep:
      Increment(row.deep);
      [[fallthrough]];
    case PairOutcome::Stage::kSolved:
      Increment(row.solved);
      RaiseTo(outcome.gap, row.worst_gap);
      break;
  }
  Increment(row.iterations[std::min<std::size_t>(static_cast<std::size_t>(outcome.iterations),
                                                 PairStatistics::kMaxIterations)]);
  Increment(row.patch_sizes[outcome.patch_size]);
}

void PairCounters::CountFallback(int type_0, int type_1, Fallback fallback) {
  Increment(RowOf(type_0, type_1).fallbacks[static_cast<std::size_t>(fallback)]);
}

std::vector<PairStatistics> PairCounters::Read() const {
  std::vector<PairStatistics> pairs;
  const auto read = [](const Counter& counter) { return counter.load(std::memory_order_relaxed); };
  for (int type_0 = 0; type_0 < kTypes; ++type_0) {
    for (int type_1 = type_0; type_1 < kTypes; ++type_1) {
      const Row& row = rows_[IndexOf(type_0, type_1)];
      PairStatistics pair;
      pair.type_0 = type_0;
      pair.type_1 = type_1;
      pair.separated = read(row.separated);
      pair.resting = read(row.recycled);
      pair.deep = read(row.deep);
      pair.solved = read(row.solved);
      for (std::size_t i = 0; i < kFallbacks; ++i) CountOf(pair, static_cast<Fallback>(i)) = read(row.fallbacks[i]);
      pair.calls = pair.separated + pair.resting + pair.solved + pair.Fallbacks();
      std::transform(row.iterations.begin(), row.iterations.end(), pair.iterations.begin(), read);
      std::transform(row.patch_sizes.begin(), row.patch_sizes.end(), pair.patch_sizes.begin(), read);
      pair.worst_gap = row.worst_gap.load(std::memory_order_relaxed);
      if (pair.calls > 0) pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
