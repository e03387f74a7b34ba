#include "narrowphase.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <new>
#include <stdexcept>
#include <string>

#include "convex_convex_algorithm.h"

namespace dgd_bullet {

Narrowphase::Narrowphase(const Options& options) : options_(options) {
  if (!(options.relative_tolerance > 0 && options.relative_tolerance < 1)) {
    throw std::invalid_argument("dgd_bullet::Options::relative_tolerance must be in (0, 1); got " +
                                std::to_string(options.relative_tolerance));
  }
  if (options.max_iterations < 1) {
    throw std::invalid_argument("dgd_bullet::Options::max_iterations must be >= 1; got " +
                                std::to_string(options.max_iterations));
  }
}

bool Narrowphase::Handles(int type_0, int type_1) {
  const auto handles = [](int type) {
    return btBroadphaseProxy::isConvex(type) && !btBroadphaseProxy::isConvex2d(type);
  };
  return handles(type_0) && handles(type_1);
}

Statistics Narrowphase::statistics() const {
  return {fallbacks_not_converged_.load(std::memory_order_relaxed),
          fallbacks_no_interior_.load(std::memory_order_relaxed), fallbacks_invalid_.load(std::memory_order_relaxed)};
}

void Narrowphase::CountFallback(dgd::Status status) {
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
