// From a contact patch to Bullet's manifold.
//
// Whoever else reads a pair's contacts, an app that asks or the pairs that share a manifold, gets them through
// addContactPoint(). A pair's own manifold holds most points from step to step, and those are brought up to date where
// they are: Bullet would make each anew, look for the one that it continues, ask what the bodies' materials make of it,
// copy it, and compute it once more in the refresh, at three times the cost.
#pragma once

#include <LinearMath/btVector3.h>

#include <span>

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_motion.h"
#include "shapes/bullet_conversions.h"

class btManifoldResult;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

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

/// Orders the points as Bullet's contact solver, which goes through them one after the other, leaves least undone:
/// around the patch, beginning with the one that carried most in the last step. Two opposite corners that come first
/// would carry three quarters of the load between them and let stacks of small boxes rock (four of 0.2 m at 60 Hz: 23
/// mm away after 5 s, 7 with this). A last point that carries much feeds the sway of high towers (scenes/tower_20.json
/// in float: 120 mm/s with an order that does not follow impulses, 2 with this; Bullet's narrowphase 42).
/// Points of multibodies' links, which another solver takes, keep their order: with this
/// one, the gripper of tests/apps drops 41 of 126 boxes in double and 44 in float, 31 without (42 at 240, 480, 1000
/// Hz).
void OrderForSolver(btPersistentManifold& manifold);

/// What Bullet's refresh of a manifold does besides bringing its points up to date: their age and callback.
void CountStep(btPersistentManifold& manifold);

/// Removes points whose distance, after a refresh, is no finite number: of bodies whose pose is no pose.
void DropPointsNotFinite(btPersistentManifold& manifold);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
