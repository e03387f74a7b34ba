// What a step makes of a manifold's points once they have their places and materials, fresh or recycled: the one list.
#pragma once

#include "dgd_bullet/linkage.h"
#include "manifold/just_touching.h"
#include "manifold/point_order.h"
#include "manifold/restitution.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// @param was_loaded  Whether a point of the pair carried something in the last step.
/// @param motion      Motion of the manifold's bodies within the step, in its order; unknown where there is no step.
/// @param order       Whether the points are ordered for the solver.
inline void FinishContacts(bool was_loaded, const PairMotion& motion, bool order, btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) PrepareRebound(manifold.getContactPoint(i), motion);
  ShowTouching(manifold, was_loaded, motion);
  if (order) OrderByImpulse(manifold);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
