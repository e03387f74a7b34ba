#include "algorithms/pair_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "dgd/assert.h"
#include "manifold/just_touching.h"
#include "report/contact_drawer.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

PairAlgorithm::~PairAlgorithm() {
  if (pair_.manifold.IsOwn()) pair_.manifold.Release(*m_dispatcher);
}

void PairAlgorithm::Process(const PairBodies& bodies, const btDispatcherInfo& info, btManifoldResult& output) {
  PairManifold& manifold = pair_.manifold;
  const PairCall call{bodies, info, *m_dispatcher, output};
  if (manifold.IsOwn() && manifold) ForgetTouching(*manifold);
  const bool can_do_without = CanDoWithoutManifold(call);
  // A manifold is not released in the step that ends the contact, since most likely such bodies touch again; nor in the
  // one that made it, which btCollisionDispatcherMt has not listed yet.
  const bool may_release = can_do_without && manifold && !pair_.had_contact;
  if ((manifold.IsNew() || !can_do_without) && !pair_.EnsureManifold(call)) {
    return Count(bodies, {.fallback = Fallback::kNoMemory});
  }
  manifold.BindTo(output);
  Count(bodies, RunPipeline(call));
  DGD_ASSERT(!pair_.had_contact || manifold);
  if (pair_.had_contact) DrawContacts(*manifold, info.m_debugDraw);
  if (may_release && !pair_.had_contact && manifold.IsEmpty()) {
    manifold.Release(*m_dispatcher);
    manifold.BindTo(output);
  }
}

bool PairAlgorithm::CanDoWithoutManifold(const PairCall& call) const {
  // Bullet wakes the neighbours of a kinematic body by their common manifold, empty or not; a user's own result may
  // read it.
  const Options& options = pair_.options();
  return !options.keep_empty_manifolds && options.warm_start && pair_.manifold.IsOwn() &&
         !call.bodies.first.getCollisionObject()->isKinematicObject() &&
         !call.bodies.second.getCollisionObject()->isKinematicObject() && !IsUserQuery(call.output);
}

void PairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  if (pair_.manifold.IsOwn() && pair_.manifold) manifolds.push_back(pair_.manifold.Get());
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
