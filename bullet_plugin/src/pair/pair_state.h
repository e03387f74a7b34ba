// What every kind of pair has from step to step, and what a call of Bullet's brings.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <memory>

#include "dgd_bullet/linkage.h"
#include "manifold/contact_recycling.h"
#include "pair/shared_state.h"
#include "pair_manifold.h"
#include "visiting_order.h"

class btDispatcher;
class btManifoldResult;
struct btDispatcherInfo;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Two bodies, in the manifold's order or in the one that their shapes are solved in.
struct PairBodies {
  PairBodies InOrder(bool is_swapped) const { return is_swapped ? PairBodies{second, first} : *this; }

  const btCollisionObjectWrapper &first, &second;
};

/// Place of a pose along a direction of the world that no scene is built along; metres.
inline btScalar OrderOf(const btTransform& pose) {
  const btVector3 direction(btScalar(0.4834), btScalar(0.5742), btScalar(0.6607));
  return direction.dot(pose.getOrigin());
}

/// Whether the shapes of `a` and `b` are solved in this order, which is the same whichever of them Bullet names first,
/// so that a pair's contacts are the same to the last bit but for the normal's sign: by their shapes' types, else by
/// OrderOf(), so that bodies that lie still keep their order. Addresses would change from run to run.
inline bool ComesBefore(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
  const int type_a = a.getCollisionShape()->getShapeType(), type_b = b.getCollisionShape()->getShapeType();
  if (type_a != type_b) return type_a < type_b;
  return OrderOf(a.getWorldTransform()) < OrderOf(b.getWorldTransform());
}

/// A call of processCollision().
struct PairCall {
  PairBodies bodies;  ///< In the manifold's order.
  const btDispatcherInfo& info;
  btDispatcher& dispatcher;
  btManifoldResult& output;
};

struct PairState {
  PairState(SharedState& shared, btPersistentManifold* shared_manifold, bool for_step)
      : narrowphase(shared), manifold(shared_manifold), is_for_step(for_step) {}

  const Options& options() const { return narrowphase.options(); }

  /// Acquires a manifold if there is none, and binds it to the call's output.
  /// @return false if the dispatcher has none left.
  bool EnsureManifold(const PairCall& call) {
    const bool was_there = bool(manifold);
    const PairBodies& bodies = call.bodies;
    if (!manifold.Acquire(call.dispatcher, *bodies.first.getCollisionObject(), *bodies.second.getCollisionObject())) {
      return false;
    }
    if (!was_there) manifold.BindTo(call.output);
    return true;
  }

  // What a pair without contacts reads comes first.
  SharedState& narrowphase;
  [[no_unique_address]] PairManifold manifold;  // What follows takes its padding.
  bool is_recyclable = false;                   ///< Whether `recycled` belongs to the manifold's contacts.
  bool had_contact = false;                     ///< Whether the last step has found contacts.
  const bool is_for_step;          ///< Whether the contacts are a step's, and may be ahead of the bodies' motion in it.
  VisitingOrder::Place place = 0;  ///< The last call's place in the thread's order of visits.
  std::unique_ptr<RecycledContacts> recycled;  ///< Made once the pair has been at rest.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
