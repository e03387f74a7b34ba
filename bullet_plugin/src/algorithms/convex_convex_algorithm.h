// The algorithm object of one pair of convex shapes: Bullet's contract on the outside, the growth distance inside.
//
// The contract (read from Bullet 3.24), besides that of pair_algorithm.h: points leave through addContactPoint(), and
// those of the pair's own manifold are written as that would leave them (manifold_writer.h); the normal points from B
// to A, A and B in the order of the call; the depth is the signed distance after margins.
#pragma once

#include "algorithms/pair_algorithm.h"
#include "dgd_bullet/linkage.h"
#include "pair/pair_cache.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ConvexConvexAlgorithm final : public PairAlgorithm {
 public:
  using PairAlgorithm::PairAlgorithm;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;

  /// The part of the motion from the bodies' transforms to their interpolation transforms that they go before they
  /// touch, or 1: by a sweep of the shapes themselves, never late. Only apps that dispatch continuously call it. As in
  /// Bullet, bodies that both move by less than their CCD motion thresholds are not swept, and the bodies' hit
  /// fractions are lowered. Children of compounds and meshes return 1, since Bullet does not give their places.
  btScalar calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1, const btDispatcherInfo& info,
                                 btManifoldResult* output) override;

 private:
  PairOutcome RunPipeline(const PairCall& call) override;

  PairCache cache_;
};

// The pool hands out slots without looking at the size: 184 bytes is the largest algorithm of Bullet's own, so every
// pool that works with Bullet holds it. The soft-body configuration's slots are 8-byte aligned.
static_assert(sizeof(ConvexConvexAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexConvexAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
