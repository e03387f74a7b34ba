// The algorithm object of a convex shape and a static plane: a closed form for the distance, and all corners of the
// face that the shape shows the plane in one step, where Bullet's own adds one a step.
//
// The contract (read from Bullet 3.24, btConvexPlaneCollisionAlgorithm), besides that of pair_algorithm.h: the manifold
// has the convex body first in either order of the call, so contacts' normals are the plane's; the plane's margin and
// scaling have no effect; boxes have sharp edges, other shapes are what Bullet's GJK sees.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>

#include "algorithms/pair_algorithm.h"
#include "dgd_bullet/linkage.h"
#include "pair/plane_pipeline.h"
#include "shapes/hull_cache.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ConvexPlaneAlgorithm final : public PairAlgorithm {
 public:
  using PairAlgorithm::PairAlgorithm;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override {
    const bool is_plane_first = body_0->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
    Process(PairBodies{*body_0, *body_1}.InOrder(is_plane_first), info, *output);
  }

  /// 1, as Bullet's: its worlds sweep shapes against planes themselves.
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }

 private:
  PairOutcome RunPipeline(const PairCall& call) override { return RunPlanePipeline(pair_, hull_, call); }

  std::shared_ptr<const CachedHull> hull_;
};

static_assert(sizeof(ConvexPlaneAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexPlaneAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
