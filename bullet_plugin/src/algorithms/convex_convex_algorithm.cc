#include "algorithms/convex_convex_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>

#include "algorithms/narrowphase.h"
#include "algorithms/shape_sweep.h"
#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "pair/pair_pipeline.h"
#include "prefetch.h"
#include "separation_report.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Whether a body moves by less than its CCD motion threshold.
bool IsSlow(const btCollisionObject& body) {
  const btVector3 way = body.getInterpolationWorldTransform().getOrigin() - body.getWorldTransform().getOrigin();
  return way.length2() < body.getCcdSquareMotionThreshold();
}

}  // namespace

void ConvexConvexAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                             const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                             btManifoldResult* output) {
  if (const void* next = VisitingOrder::OfThisThread().Visit(this, pair_.place)) {
    Prefetch(next, sizeof(ConvexConvexAlgorithm));
  }
  if (PairObserver* observer = pair_.options().pair_observer) observer->OnPair(*body_0, *body_1);
  const PairBodies bodies{*body_0, *body_1};
  Process(bodies, info, *output);
  if (separation_report == nullptr) return;
  separation_report->algorithm = this;
  separation_report->is_apart =
      separation_report->separation > 0 && IsUnchangedBy({bodies, info, *m_dispatcher, *output});
}

PairOutcome ConvexConvexAlgorithm::RunPipeline(const PairCall& call) {
  return dgd_bullet::RunPipeline(pair_, cache_, call);
}

btScalar ConvexConvexAlgorithm::calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1,
                                                      const btDispatcherInfo&, btManifoldResult*) {
  constexpr btScalar kNever = 1;
  const btCollisionShape *shape_0 = body_0->getCollisionShape(), *shape_1 = body_1->getCollisionShape();
  if (!Narrowphase::Handles(shape_0->getShapeType(), shape_1->getShapeType()) || (IsSlow(*body_0) && IsSlow(*body_1))) {
    return kNever;
  }
  const auto moving = [](const btCollisionObject& body, PairCache::Hull& hull) -> MovingShape {
    return {*static_cast<const btConvexShape*>(body.getCollisionShape()), body.getWorldTransform(),
            body.getInterpolationWorldTransform(), hull};
  };
  const MovingShape a = moving(*body_0, cache_.hull_a()), b = moving(*body_1, cache_.hull_b());
  SharedState& narrowphase = pair_.narrowphase;
  const dgd::TimeOfImpactResult<double> impact =
      SweepShapes(a, b, pair_.options().geometry_mode, narrowphase.hulls(), HullUse::kStep);
  if (!Meet(impact, a, b)) return kNever;
  const btScalar fraction = RoundDown(impact.time);
  DGD_ASSERT(fraction >= 0 && fraction <= 1);
  for (btCollisionObject* body : {body_0, body_1}) body->setHitFraction(std::min(body->getHitFraction(), fraction));
  return fraction;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
