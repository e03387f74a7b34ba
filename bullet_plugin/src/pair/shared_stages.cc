#include "pair/shared_stages.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btPolyhedralConvexShape.h>

#include "contact_range.h"
#include "dgd/assert.h"
#include "manifold/manifold_writer.h"
#include "pair_motion.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

bool GetsNearestOnly(const PairCall& call, bool is_for_step) {
  if (!IsUserQuery(call.output) || (is_for_step && call.info.m_timeStep > 0)) return false;
  const auto has_features = [](const btCollisionObjectWrapper& body) {
    const btCollisionShape& shape = *body.getCollisionShape();
    return shape.isPolyhedral() && static_cast<const btPolyhedralConvexShape&>(shape).getConvexPolyhedron() != nullptr;
  };
  return !has_features(call.bodies.first) || !has_features(call.bodies.second);
}

bool UpdateRecycledContacts(PairState& pair, const RecycledContacts::Side& a, const RecycledContacts::Side& b,
                            const PairCall& call) {
  if (IsUserQuery(call.output)) return false;
  DGD_ASSERT(pair.recycled != nullptr && pair.manifold.IsOwn() && pair.manifold);
  // Bodies that lie still, or move together, do not approach each other: only a rebound has to know how little.
  PairMotion motion;
  if (pair.is_for_step && Rebounds(call.output)) {
    const BoundedBody bounded_a(*call.bodies.first.getCollisionObject()),
        bounded_b(*call.bodies.second.getCollisionObject());
    motion = MotionOfStep(pair.manifold, bounded_a, bounded_b, call.info);
  }
  return pair.recycled->Update(a, b, pair.options(), call.info.m_timeStep, motion, *pair.manifold, call.output);
}

PairOutcome WriteContacts(PairState& pair, const PairCall& call, const PairContacts& contacts, bool is_swapped,
                          const PairOutcome& outcome) {
  const dgd::ContactPatch<double>& patch = contacts.patch;
  DGD_ASSERT(patch.size >= 0 && patch.size <= dgd::ContactPatch<double>::kMaxPoints);
  pair.had_contact = false;
  if (patch.size > 0 && !pair.EnsureManifold(call)) return {.fallback = Fallback::kNoMemory};
  pair.had_contact = patch.size > 0;
  const Options& options = pair.options();
  if (!pair.manifold.IsOwn()) {
    WritePatch(patch, contacts.normal, call.output);
  } else if (patch.size > 0 || !pair.manifold.IsEmpty()) {
    const PairMotion motion = is_swapped ? contacts.motion.Reversed() : contacts.motion;
    UpdateManifold(patch, contacts.normal, motion, ManifoldUpdateOf(options, call.output), call.output);
  }
  if (!pair.had_contact || !contacts.may_recycle || !MayRecycle(options, pair.manifold)) return outcome;
  const PairBodies solved = call.bodies.InOrder(is_swapped);
  const ReferenceFace face = ReferenceFaceOf(solved.first, solved.second, contacts.side, *pair.manifold);
  pair.is_recyclable =
      RecycledContacts::Cache(solved.first, solved.second, face, contacts.motion, *pair.manifold, pair.recycled);
  return outcome;
}

PairOutcome SolveByBullet(PairState& pair, const PairCall& call, Fallback reason) {
  // Bullet has no result for what is no shape or no pose either: it reads points that a hull has not, and stores NaN.
  if (!IsSolvedByBullet(reason)) {
    if (pair.manifold.IsOwn() && pair.manifold) pair.manifold->clearManifold();
    return {.fallback = reason};
  }
  if (!pair.EnsureManifold(call)) return {.fallback = Fallback::kNoMemory};
  DGD_ASSERT(call.output.getPersistentManifold() == pair.manifold.Get());
  pair.narrowphase.FallBack(call.dispatcher, &call.bodies.first, &call.bodies.second, call.info, call.output);
  if (pair.manifold.IsOwn()) {
    call.output.refreshContactPoints();
    DropPointsNotFinite(*pair.manifold);
  }
  return {.fallback = reason};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
