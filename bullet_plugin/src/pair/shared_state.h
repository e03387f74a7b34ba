// What the pairs of one dispatcher share: options, hulls, counters, and Bullet's own algorithm to fall back to.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "dgd_bullet/statistics.h"
#include "fallback.h"
#include "pair_outcome.h"
#include "report/pair_counters.h"
#include "shapes/hull_cache.h"

class btDispatcher;
class btManifoldResult;
struct btCollisionObjectWrapper;
struct btDispatcherInfo;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Outlives the dispatcher and its pairs. All members may be used by several threads at once.
class SharedState {
 public:
  /// Throws std::invalid_argument naming an option that is out of range.
  explicit SharedState(const Options& options);

  const Options& options() const { return options_; }
  /// Whether a step's contacts may be ahead of the bodies' motion in it, which Bullet's own accumulation of single
  /// points does not support.
  bool UsesMotion() const { return options_.contact_patch; }
  HullCache& hulls() { return hulls_; }
  /// @param is_user_query  Whether a user queries the contacts themselves.
  HullUse HullUseFor(bool is_user_query) const {
    return is_user_query && options_.warm_start ? HullUse::kApp : HullUse::kStep;
  }
  Statistics statistics() const;

  /// Counts how a call of shapes of two types has ended.
  void Count(int type_0, int type_1, const PairOutcome& outcome) {
    if (outcome.fallback) return CountFallback(type_0, type_1, *outcome.fallback);
    if (pair_counters_ != nullptr) pair_counters_->Count(type_0, type_1, outcome);
  }

  /// Counts a call that has not been solved, and reports the first of its kind.
  void CountFallback(int type_0, int type_1, Fallback fallback);

  /// Solves the pair by Bullet's GJK/EPA, into output's manifold.
  void FallBack(btDispatcher& dispatcher, const btCollisionObjectWrapper* body_0,
                const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info, btManifoldResult& output);

 private:
  const Options options_;
  HullCache hulls_;
  btGjkEpaPenetrationDepthSolver penetration_solver_;
  std::unique_ptr<PairCounters> pair_counters_;
  std::array<std::atomic<std::uint64_t>, kFallbacks> fallbacks_{};
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
