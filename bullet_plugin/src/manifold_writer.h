// From a contact patch to Bullet's manifold.
//
// Whoever else reads a pair's contacts, an app that asks or the pairs that share a manifold, gets them through
// addContactPoint(). A pair's own manifold holds most points from step to step, and those are brought up to date where
// they are: Bullet would make each anew, look for the one that it continues, ask what the bodies' materials make of it,
// copy it, and compute it once more in the refresh, at three times the cost.
#pragma once

#include <LinearMath/btVector3.h>

#include <span>

#include "bullet_conversions.h"
#include "dgd/contact_patch.h"
#include "pair_motion.h"

class btManifoldResult;
class btPersistentManifold;

namespace dgd_bullet {

struct MeshTriangle;

/// A contact in Bullet's numbers, of bodies A and B.
struct ManifoldContact {
  btVector3 OnA() const { return on_b + normal_on_b * separation; }

  btVector3 normal_on_b;                   ///< Unit, from B to A, world.
  btVector3 on_b;                          ///< World, metres.
  btScalar separation;                     ///< Metres, negative for overlap.
  const MeshTriangle* triangle = nullptr;  ///< That it is on, if body B is a mesh. Outlives the contact.
};

/// Hands the patch over, but for points beyond what Bullet can compute with. `normal` points from A to B, the shapes in
/// the order of the call; Bullet's points from B to A.
void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output);

/// What becomes of the points that a pair's own manifold holds already.
struct ManifoldUpdate {
  bool drop_stale = true;  ///< Points that the patch does not continue are dropped, so that none outlives the geometry
                           ///< that made it (bullet3 issues 1739, 2646); else Bullet drops them where they part.
  bool hold_stuck = true;  ///< Points that stick are anchored (friction_anchors.h), if stale ones are dropped.
};

/// Makes the points of a manifold that this pair owns those of the patch. A point of the patch continues the nearest
/// one within the breaking threshold, by its position on body A, as in Bullet's own cache: its impulse is kept.
/// Bullet's callbacks for contacts are called as Bullet would.
/// @param normal  From body A to body B, in the manifold's own order.
/// @param motion  Of the manifold's bodies within the step, where its points are ahead of that; for rebounds
///                (restitution.h) and anchors.
/// @param output  Of the call; its manifold is the pair's.
void UpdateManifold(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                    const ManifoldUpdate& update, btManifoldResult& output);

/// The same for contacts with normals of their own, as those of a mesh. As long as there is any, the manifold is never
/// without points, so that Bullet's callbacks for the beginning and the end of a contact are not called in between.
/// @param contacts  Of the manifold's bodies in its own order; MANIFOLD_CACHE_SIZE at most.
void UpdateManifold(std::span<const ManifoldContact> contacts, const PairMotion& motion, const ManifoldUpdate& update,
                    btManifoldResult& output);

/// Puts the points that carried more in the last step first. Bullet's contact solver goes through a manifold in this
/// order, and its last word is the last point's: where that is one that carries much, the tilt that each level of a
/// tower is left with feeds a sway. By measurement (contact_report): the bodies of scenes/tower_20.json move at 90 mm/s
/// without this, at 1.4 with it (float; double 94, 0.5; no resting contacts kept).
void OrderByImpulse(btPersistentManifold& manifold);

/// What Bullet's refresh of a manifold does besides bringing its points up to date: their age and callback.
void CountStep(btPersistentManifold& manifold);

/// Removes points whose distance, after a refresh, is no finite number: of bodies whose pose is no pose.
void DropPointsNotFinite(btPersistentManifold& manifold);

}  // namespace dgd_bullet
