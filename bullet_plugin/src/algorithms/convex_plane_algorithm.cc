#include "algorithms/convex_plane_algorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "pair/plane_pipeline.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void ConvexPlaneAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                            const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                            btManifoldResult* output) {
  const bool is_plane_first = body_0->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
  Process(PairBodies{*body_0, *body_1}.InOrder(is_plane_first), info, *output);
}

PairOutcome ConvexPlaneAlgorithm::RunPipeline(const PairCall& call) { return RunPlanePipeline(pair_, hull_, call); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
