#include "algorithms/narrowphase.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <new>
#include <utility>

#include "algorithms/compound_algorithm.h"
#include "algorithms/convex_convex_algorithm.h"
#include "algorithms/convex_mesh_algorithm.h"
#include "algorithms/convex_plane_algorithm.h"

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

Narrowphase::Narrowphase(const Options& options) : SharedState(options) {}

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

bool Narrowphase::HandlesCompound(int type_0, int type_1) {
  const auto handles = [](int type) {
    return type == COMPOUND_SHAPE_PROXYTYPE || btBroadphaseProxy::isConvex(type) || type == STATIC_PLANE_PROXYTYPE ||
           HandlesMesh(BOX_SHAPE_PROXYTYPE, type);
  };
  return (type_0 == COMPOUND_SHAPE_PROXYTYPE && handles(type_1)) ||
         (type_1 == COMPOUND_SHAPE_PROXYTYPE && handles(type_0));
}

btCollisionAlgorithmCreateFunc* Narrowphase::ContactCreateFunc(int type_0, int type_1) {
  if (Handles(type_0, type_1)) return &contact_create_func_;
  if (HandlesPlane(type_0, type_1) || HandlesPlane(type_1, type_0)) return &plane_contact_create_func_;
  if (HandlesMesh(type_0, type_1)) return &mesh_create_func_;
  if (HandlesMesh(type_1, type_0)) return &swapped_mesh_create_func_;
  if (HandlesCompound(type_0, type_1)) return &compound_create_func_;
  return nullptr;
}

btCollisionAlgorithmCreateFunc* Narrowphase::ClosestPointsCreateFunc(int type_0, int type_1) {
  if (Handles(type_0, type_1)) return &closest_points_create_func_;
  if (HandlesPlane(type_0, type_1) || HandlesPlane(type_1, type_0)) return &plane_closest_points_create_func_;
  return nullptr;
}

template <class Algorithm>
btCollisionAlgorithm* Narrowphase::PairCreateFunc<Algorithm>::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body_0,
    const btCollisionObjectWrapper* body_1) {
  auto* algorithm = Make<Algorithm>(info, narrowphase, is_for_step);
  if (algorithm == nullptr) {
    narrowphase.CountFallback(body_0->getCollisionShape()->getShapeType(), body_1->getCollisionShape()->getShapeType(),
                              Fallback::kNoMemory);
  }
  return algorithm;
}

btCollisionAlgorithm* Narrowphase::MeshCreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                            const btCollisionObjectWrapper* body_0,
                                                                            const btCollisionObjectWrapper* body_1) {
  return Make<ConvexMeshAlgorithm>(info, narrowphase, body_0, body_1, is_swapped);
}

btCollisionAlgorithm* Narrowphase::OfCompounds::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                         const btCollisionObjectWrapper*,
                                                                         const btCollisionObjectWrapper*) {
  return Make<CompoundAlgorithm>(info, narrowphase);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
