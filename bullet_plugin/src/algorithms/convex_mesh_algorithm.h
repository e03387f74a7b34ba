// The algorithm object of a convex shape and a mesh or heightfield: the contacts of all triangles are gathered, and the
// manifold then has those of them that count (mesh_contacts.h) and matter most (contact_reduction.h), updated as a
// pair's of two convex shapes. What the queries of the triangles leave is kept from step to step (triangle_states.h).
//
// The contract (read from Bullet 3.24, btConvexConcaveCollisionAlgorithm): the pair has one manifold, the convex body
// first in either order of the call; each triangle is a shape of its own with the mesh's margin, in a wrapper that the
// result has in the mesh's place. By that an app's callbacks identify it (bound_part.h).
#pragma once

#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>

#include <memory>

#include "algorithms/narrowphase.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct MeshStep;
struct MeshQuery;

class ConvexMeshAlgorithm final : public btConvexConcaveCollisionAlgorithm {
 public:
  /// @param is_swapped  Whether the mesh is the first of the two bodies.
  ConvexMeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                      const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1, bool is_swapped);
  ~ConvexMeshAlgorithm() override;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;

 private:
  /// @return false without memory; no contacts have been written then.
  bool FindContacts(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh,
                    const btDispatcherInfo& info, btManifoldResult& output);

  /// Makes the manifold's contacts the ones that matter most of those gathered.
  /// @param has_foreign  Whether an app's own algorithm has written some into the manifold.
  void Write(const MeshQuery& query, bool has_foreign, const btDispatcherInfo& info, btManifoldResult& output);

  Narrowphase& narrowphase_;
  btPersistentManifold* manifold_ = nullptr;  // The base class's.
  std::unique_ptr<MeshStep> step_;            // Null without memory for it.
};

static_assert(sizeof(ConvexMeshAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexMeshAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
