#include "algorithms/narrowphase.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cmath>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "algorithms/convex_convex_algorithm.h"
#include "algorithms/convex_mesh_algorithm.h"
#include "algorithms/convex_plane_algorithm.h"
#include "algorithms/finite_result.h"
#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Makes an algorithm in a dispatcher's memory; Bullet frees the memory of algorithms that it owns.
/// @return null without memory: Bullet leaves out the pair then, and tries again in the next step.
template <class Algorithm, class... Arguments>
Algorithm* Make(const btCollisionAlgorithmConstructionInfo& info, Arguments&&... arguments) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
  return memory == nullptr ? nullptr : new (memory) Algorithm(info, std::forward<Arguments>(arguments)...);
}

}  // namespace

void PrintToStandardError(const char* message) noexcept { std::fprintf(stderr, "%s\n", message); }

Narrowphase::Narrowphase(const Options& options) : options_(options) {
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
  require(options.angular_tolerance > 0 && options.angular_tolerance <= 1.5, "angular_tolerance", "in (0, 1.5] rad",
          options.angular_tolerance);
  require(options.contact_distance >= 0 && std::isfinite(options.contact_distance), "contact_distance",
          ">= 0 and finite, in metres", options.contact_distance);
  if (options.count_pairs) pair_counters_ = std::make_unique<PairCounters>();
}

bool Narrowphase::Handles(int type_0, int type_1) {
  const auto handles = [](int type) {
    return btBroadphaseProxy::isConvex(type) && !btBroadphaseProxy::isConvex2d(type);
  };
  return handles(type_0) && handles(type_1);
}

bool Narrowphase::HandlesMesh(int convex_type, int mesh_type) {
  switch (mesh_type) {
    case TRIANGLE_MESH_SHAPE_PROXYTYPE:
    case SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE:
    case MULTIMATERIAL_TRIANGLE_MESH_PROXYTYPE:
    case TERRAIN_SHAPE_PROXYTYPE:
      return Handles(convex_type, TRIANGLE_SHAPE_PROXYTYPE);
    default:
      return false;
  }
}

bool Narrowphase::HandlesPlane(int convex_type, int plane_type) {
  return plane_type == STATIC_PLANE_PROXYTYPE && Handles(convex_type, BOX_SHAPE_PROXYTYPE);
}

btCollisionAlgorithmCreateFunc* Narrowphase::ContactCreateFunc(int type_0, int type_1) {
  if (Handles(type_0, type_1)) return &contact_create_func_;
  if (HandlesPlane(type_0, type_1) || HandlesPlane(type_1, type_0)) return &plane_contact_create_func_;
  if (HandlesMesh(type_0, type_1)) return &mesh_create_func_;
  if (HandlesMesh(type_1, type_0)) return &swapped_mesh_create_func_;
  return nullptr;
}

btCollisionAlgorithmCreateFunc* Narrowphase::ClosestPointsCreateFunc(int type_0, int type_1) {
  if (Handles(type_0, type_1)) return &closest_points_create_func_;
  if (HandlesPlane(type_0, type_1) || HandlesPlane(type_1, type_0)) return &plane_closest_points_create_func_;
  return nullptr;
}

Statistics Narrowphase::statistics() const {
  Statistics statistics;
  for (std::size_t i = 0; i < kFallbacks; ++i) {
    CountOf(statistics, static_cast<Fallback>(i)) = fallbacks_[i].load(std::memory_order_relaxed);
  }
  if (pair_counters_ != nullptr) statistics.pairs = pair_counters_->Read();
  return statistics;
}

void Narrowphase::CountFallback(const btCollisionShape& shape_0, const btCollisionShape& shape_1, Fallback fallback) {
  const int type_0 = shape_0.getShapeType(), type_1 = shape_1.getShapeType();
  DGD_ASSERT(static_cast<std::size_t>(fallback) < kFallbacks);
  const bool is_first = fallbacks_[static_cast<std::size_t>(fallback)].fetch_add(1, std::memory_order_relaxed) == 0;
  if (is_first && options_.on_first_fallback != nullptr) {
    options_.on_first_fallback(Describe(fallback, type_0, type_1).data());
  }
  if (pair_counters_ != nullptr) pair_counters_->CountFallback(type_0, type_1, fallback);
}

void Narrowphase::FallBack(btDispatcher& dispatcher, const btCollisionObjectWrapper* body_0,
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

template <class Algorithm>
btCollisionAlgorithm* Narrowphase::PairCreateFunc<Algorithm>::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body_0,
    const btCollisionObjectWrapper* body_1) {
  auto* algorithm = Make<Algorithm>(info, narrowphase, is_for_step);
  if (algorithm == nullptr) {
    narrowphase.CountFallback(*body_0->getCollisionShape(), *body_1->getCollisionShape(), Fallback::kNoMemory);
  }
  return algorithm;
}

btCollisionAlgorithm* Narrowphase::MeshCreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                            const btCollisionObjectWrapper* body_0,
                                                                            const btCollisionObjectWrapper* body_1) {
  return Make<ConvexMeshAlgorithm>(info, narrowphase, body_0, body_1, is_swapped);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
