// The algorithm object of a convex shape and a mesh or heightfield: Bullet's own, but that the triangles' algorithms
// are kept from step to step (triangle_pairs.h).
//
// The contract (read from Bullet 3.24, btConvexConcaveCollisionAlgorithm): the pair has one manifold, the convex body
// first whatever the order of the call, which all triangles write into, and which is refreshed when all have; each
// triangle is a shape of its own with the mesh's margin, in a wrapper that the result is shown in the mesh's place. By
// that an app's callbacks know it.
#pragma once

#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>

#include <memory>

#include "narrowphase.h"
#include "triangle_pairs.h"

namespace dgd_bullet {

class ConvexMeshAlgorithm final : public btConvexConcaveCollisionAlgorithm {
 public:
  /// @param is_swapped  Whether the mesh is the first of the two bodies.
  ConvexMeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const Narrowphase& narrowphase,
                      const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1, bool is_swapped);

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;

 private:
  const Options& options_;
  btPersistentManifold* manifold_ = nullptr;  // The base's.
  std::unique_ptr<TrianglePairs> pairs_;      // None without memory for it.
};

// As convex_convex_algorithm.h says of its own.
static_assert(sizeof(ConvexMeshAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexMeshAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace dgd_bullet
