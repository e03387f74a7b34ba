// What makes the algorithm objects of a dispatcher's pairs, with what these share.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

#include "algorithms/concurrent_pairs.h"
#include "dgd_bullet/linkage.h"
#include "pair/shared_state.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ConvexConvexAlgorithm;
class ConvexPlaneAlgorithm;

/// Outlives the dispatcher and its pairs.
class Narrowphase : public SharedState {
 public:
  /// Throws std::invalid_argument naming an option that is out of range.
  explicit Narrowphase(const Options& options);

  /// Whether the growth distance solves pairs of these shape types: both convex and neither two-dimensional, which
  /// Bullet's GJK treats in another way.
  static bool Handles(int type_0, int type_1);

  /// Whether it solves the triangles of such a mesh, or of a heightfield, against such a convex shape. Other concave
  /// types are no meshes, or have algorithms of their own.
  static bool HandlesMesh(int convex_type, int mesh_type);

  /// Whether it solves such a convex shape against a static plane.
  static bool HandlesPlane(int convex_type, int plane_type);

  /// Whether it finds the children of compounds for such a pair, which go to what the dispatcher has for their types.
  static bool HandlesCompound(int type_0, int type_1);

  /// What makes the algorithm of a pair of shape types, for the two tables of a dispatcher; null where that is left to
  /// Bullet.
  btCollisionAlgorithmCreateFunc* ContactCreateFunc(int type_0, int type_1);
  btCollisionAlgorithmCreateFunc* ClosestPointsCreateFunc(int type_0, int type_1);

 private:
  /// Makes a ConvexConvexAlgorithm, or a ConvexPlaneAlgorithm.
  template <class Algorithm>
  struct PairCreateFunc : ConcurrentCreateFunc {
    PairCreateFunc(Narrowphase& shared, bool for_step) : narrowphase(shared), is_for_step(for_step) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* body_0,
                                                   const btCollisionObjectWrapper* body_1) override;
    Narrowphase& narrowphase;
    const bool is_for_step;
  };
  struct MeshCreateFunc : btCollisionAlgorithmCreateFunc {
    MeshCreateFunc(Narrowphase& shared, bool is_mesh_first) : narrowphase(shared), is_swapped(is_mesh_first) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* body_0,
                                                   const btCollisionObjectWrapper* body_1) override;
    Narrowphase& narrowphase;
    const bool is_swapped;
  };

  struct OfCompounds : CompoundCreateFunc {
    explicit OfCompounds(const Narrowphase& shared) : narrowphase(shared) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* body_0,
                                                   const btCollisionObjectWrapper* body_1) override;
    const Narrowphase& narrowphase;
  };

  PairCreateFunc<ConvexConvexAlgorithm> contact_create_func_{*this, UsesMotion()};
  PairCreateFunc<ConvexConvexAlgorithm> closest_points_create_func_{*this, false};
  PairCreateFunc<ConvexPlaneAlgorithm> plane_contact_create_func_{*this, UsesMotion()};
  PairCreateFunc<ConvexPlaneAlgorithm> plane_closest_points_create_func_{*this, false};
  MeshCreateFunc mesh_create_func_{*this, false}, swapped_mesh_create_func_{*this, true};
  OfCompounds compound_create_func_{*this};
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
