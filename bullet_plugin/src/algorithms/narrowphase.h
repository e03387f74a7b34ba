// What the pairs of one dispatcher share: options, hulls, counters, and Bullet's own algorithm to fall back to; and
// what makes their algorithm objects.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include <array>
#include <atomic>
#include <memory>

#include "algorithms/fallback.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "dgd_bullet/statistics.h"
#include "dispatch/concurrent_pairs.h"
#include "pipeline/pair_outcome.h"
#include "record/pair_counters.h"
#include "shapes/hull_cache.h"

class btDispatcher;
class btManifoldResult;
struct btDispatcherInfo;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ConvexConvexAlgorithm;
class ConvexPlaneAlgorithm;

/// Outlives the dispatcher and its pairs. All members may be used by several threads at once.
class Narrowphase {
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

  /// What makes the algorithm of a pair of shape types, for the two tables of a dispatcher; null where that is left to
  /// Bullet.
  btCollisionAlgorithmCreateFunc* ContactCreateFunc(int type_0, int type_1);
  btCollisionAlgorithmCreateFunc* ClosestPointsCreateFunc(int type_0, int type_1);

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

  /// Counts how a call of two shapes has ended.
  void Count(const btCollisionShape& shape_0, const btCollisionShape& shape_1, const PairOutcome& outcome) {
    if (outcome.fallback) return CountFallback(shape_0, shape_1, *outcome.fallback);
    if (pair_counters_ != nullptr) pair_counters_->Count(shape_0.getShapeType(), shape_1.getShapeType(), outcome);
  }

  /// Counts a call that has not been solved, and reports the first of its kind.
  void CountFallback(const btCollisionShape& shape_0, const btCollisionShape& shape_1, Fallback fallback);

  /// Solves the pair by Bullet's GJK/EPA, into output's manifold.
  void FallBack(btDispatcher& dispatcher, const btCollisionObjectWrapper* body_0,
                const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info, btManifoldResult& output);

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
    MeshCreateFunc(const Narrowphase& shared, bool is_mesh_first) : narrowphase(shared), is_swapped(is_mesh_first) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* body_0,
                                                   const btCollisionObjectWrapper* body_1) override;
    const Narrowphase& narrowphase;
    const bool is_swapped;
  };

  const Options options_;
  PairCreateFunc<ConvexConvexAlgorithm> contact_create_func_{*this, UsesMotion()};
  PairCreateFunc<ConvexConvexAlgorithm> closest_points_create_func_{*this, false};
  PairCreateFunc<ConvexPlaneAlgorithm> plane_contact_create_func_{*this, UsesMotion()};
  PairCreateFunc<ConvexPlaneAlgorithm> plane_closest_points_create_func_{*this, false};
  MeshCreateFunc mesh_create_func_{*this, false}, swapped_mesh_create_func_{*this, true};
  HullCache hulls_;
  btGjkEpaPenetrationDepthSolver penetration_solver_;
  std::unique_ptr<PairCounters> pair_counters_;
  std::array<std::atomic<std::uint64_t>, kFallbacks> fallbacks_{};
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
