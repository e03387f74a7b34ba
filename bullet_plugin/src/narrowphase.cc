#include "narrowphase.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

#include "convex_convex_algorithm.h"

namespace dgd_bullet {

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

Statistics Narrowphase::statistics() const {
  Statistics statistics;
  statistics.fallbacks_not_converged = fallbacks_not_converged_.load(std::memory_order_relaxed);
  statistics.fallbacks_no_interior = fallbacks_no_interior_.load(std::memory_order_relaxed);
  statistics.fallbacks_invalid = fallbacks_invalid_.load(std::memory_order_relaxed);
  if (pair_counters_ != nullptr) statistics.pairs = pair_counters_->Read();
  return statistics;
}

void Narrowphase::CountFallback(const btCollisionShape& shape_0, const btCollisionShape& shape_1, dgd::Status status) {
  switch (status) {
    case dgd::Status::kInvalidInput:
      fallbacks_invalid_.fetch_add(1, std::memory_order_relaxed);
      break;
    case dgd::Status::kNoInterior:
      fallbacks_no_interior_.fetch_add(1, std::memory_order_relaxed);
      break;
    default:
      fallbacks_not_converged_.fetch_add(1, std::memory_order_relaxed);
  }
  if (pair_counters_ != nullptr) {
    pair_counters_->CountFallback(shape_0.getShapeType(), shape_1.getShapeType(), status);
  }
}

void Narrowphase::FallBack(btDispatcher& dispatcher, const btCollisionObjectWrapper* body_0,
                           const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                           btManifoldResult& output) {
  btCollisionAlgorithmConstructionInfo construction(&dispatcher, 0);
  construction.m_manifold = output.getPersistentManifold();
  btCollisionAlgorithm* algorithm = fallback_.CreateCollisionAlgorithm(construction, body_0, body_1);
  algorithm->processCollision(body_0, body_1, info, &output);
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
}

btCollisionAlgorithm* Narrowphase::PairCreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                            const btCollisionObjectWrapper*,
                                                                            const btCollisionObjectWrapper*) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(ConvexConvexAlgorithm));
  return new (memory) ConvexConvexAlgorithm(info, narrowphase, speculative);
}

}  // namespace dgd_bullet
