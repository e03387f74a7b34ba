// The writing of a contact patch into Bullet's manifold.
//
// Other readers of a pair's contacts, a user's query or the pairs that share a manifold, get them through
// addContactPoint(). A pair's own manifold has most points from step to step, and those are updated in place: Bullet
// would make each from scratch, look for the one that it continues, combine the bodies' materials, copy it, and compute
// it once more in the refresh, at three times the cost.
#pragma once

#include <LinearMath/btVector3.h>

#include <span>

#include "bullet_conversions.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pair_manifold.h"
#include "pair_motion.h"

class btManifoldResult;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct MeshTriangle;
struct Options;

/// A contact of bodies A and B in Bullet's precision.
struct ManifoldContact {
  btVector3 normal_on_b;                   ///< Normal from B to A, unit, world.
  btVector3 on_a, on_b;                    ///< Places, world, metres; ahead of touching, each on its own body.
  btScalar separation;                     ///< Separation in metres, negative for overlap.
  const MeshTriangle* triangle = nullptr;  ///< The triangle, if body B is a mesh; outlives the contact.
};

/// Adds a patch through addContactPoint(), except for points beyond what Bullet can compute with. `normal` points from
/// A to B, the shapes in the order of the call; Bullet's points from B to A.
void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output);

/// The update of the points that a pair's own manifold has already.
struct ManifoldUpdate {
  bool drop_stale = true;  ///< Points that the patch does not continue are dropped, so that none outlives the geometry
                           ///< that made it (bullet3 issues 1739, 2646); else Bullet drops them where they part.
  bool use_friction_anchors =
      true;                      ///< Points that stick are anchored (friction_anchors.h), if stale ones are dropped.
  bool order_by_impulse = true;  ///< The points are ordered for the solver (point_order.h).
};

/// The update of the manifold of a call's bodies.
ManifoldUpdate ManifoldUpdateOf(const Options& options, const btManifoldResult& output);

/// Makes the points of a manifold that this pair owns those of the patch. A point of the patch continues the nearest
/// one within the breaking threshold, by its position on body A, as in Bullet's own cache: its impulse is kept.
/// Bullet's callbacks for contacts are called as Bullet would call them.
/// @param normal  From body A to body B, in the manifold's own order.
/// @param motion  Motion of the manifold's bodies within the step, where its points are ahead of that; for rebounds
///                (restitution.h) and anchors.
/// @param output  The call's; its manifold is the pair's.
void UpdateManifold(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                    const ManifoldUpdate& update, btManifoldResult& output);

/// Makes the points of a manifold those of contacts with normals of their own, as those of a mesh. As long as there is
/// any, the manifold is never without points, so that Bullet's callbacks for the beginning and the end of a contact are
/// not called in between.
/// @param contacts  Contacts of the manifold's bodies in its own order; MANIFOLD_CACHE_SIZE at most.
void UpdateManifold(std::span<const ManifoldContact> contacts, const PairMotion& motion, const ManifoldUpdate& update,
                    btManifoldResult& output);

/// What Bullet's refresh of a manifold does besides updating its points: their age and callback.
void CountStep(btPersistentManifold& manifold);

/// Removes points whose distance, after a refresh, is not finite: those of bodies whose pose is not.
void DropPointsNotFinite(btPersistentManifold& manifold);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
