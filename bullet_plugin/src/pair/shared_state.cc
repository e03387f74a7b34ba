#include "pair/shared_state.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "dgd/assert.h"
#include "dgd/contact_patch.h"
#include "finite_result.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void PrintToStandardError(const char* message) noexcept { std::fprintf(stderr, "%s\n", message); }

SharedState::SharedState(const Options& options) : options_(options) {
  const auto require = [](bool in_range, const char* name, const char* range, double value) {
    if (in_range) return;
    throw std::invalid_argument(std::string("dgd_bullet::Options::") + name + " must be " + range + "; got " +
                                std::to_string(value));
  };
  require(options.relative_tolerance > 0 && options.relative_tolerance < 1, "relative_tolerance", "in (0, 1)",
          options.relative_tolerance);
  require(options.max_iterations >= 1, "max_iterations", ">= 1", options.max_iterations);
  require(options.patch_size >= 1 && options.patch_size <= dgd::ContactPatch<double>::kMaxPoints, "patch_size",
          "1 to 4", options.patch_size);
  require(options.contact_distance >= 0 && std::isfinite(options.contact_distance), "contact_distance",
          ">= 0 and finite, in metres", options.contact_distance);
  if (options.count_pairs) pair_counters_ = std::make_unique<PairCounters>();
}

Statistics SharedState::statistics() const {
  Statistics statistics;
  for (std::size_t i = 0; i < kFallbacks; ++i) {
    CountOf(statistics, static_cast<Fallback>(i)) = fallbacks_[i].load(std::memory_order_relaxed);
  }
  if (pair_counters_ != nullptr) statistics.pairs = pair_counters_->Read();
  return statistics;
}

void SharedState::CountFallback(int type_0, int type_1, Fallback fallback) {
  DGD_ASSERT(static_cast<std::size_t>(fallback) < kFallbacks);
  const bool is_first = fallbacks_[static_cast<std::size_t>(fallback)].fetch_add(1, std::memory_order_relaxed) == 0;
  if (is_first && options_.on_first_fallback != nullptr) {
    options_.on_first_fallback(Describe(fallback, type_0, type_1).data());
  }
  if (pair_counters_ != nullptr) pair_counters_->CountFallback(type_0, type_1, fallback);
}

void SharedState::FallBack(btDispatcher& dispatcher, const btCollisionObjectWrapper* body_0,
                           const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                           btManifoldResult& output) {
  // On the stack: where Bullet's pools are full, there is a result all the same.
  constexpr int kNoPerturbations = 0, kPointsToPerturb = 3;  // The defaults of its CreateFunc.
  DGD_ASSERT(output.getPersistentManifold() != nullptr);
  const btCollisionAlgorithmConstructionInfo construction(&dispatcher, 0);
  btConvexConvexAlgorithm algorithm(output.getPersistentManifold(), construction, body_0, body_1, &penetration_solver_,
                                    kNoPerturbations, kPointsToPerturb);
  FiniteResult finite(output);
  algorithm.processCollision(body_0, body_1, info, &finite);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
