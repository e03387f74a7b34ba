// From a contact patch to Bullet's manifold, through the one channel that Bullet allows: addContactPoint().
#pragma once

#include "bullet_conversions.h"
#include "dgd/contact_patch.h"

class btManifoldResult;
class btPersistentManifold;

namespace dgd_bullet {

/// Removes the cached points that no point of the patch continues, so that none outlives the geometry that made it
/// (bullet3 issues 1739, 2646). A point of the patch continues the nearest cached one within the breaking threshold,
/// by its position on body A, as Bullet's own cache does: its impulse is kept.
/// For manifolds that this pair owns only: a shared one holds other pairs' points.
void DropStalePoints(btPersistentManifold& manifold, const dgd::ContactPatch<double>& patch);

/// Hands the patch over, but for points beyond what Bullet can compute with. `normal` points from A to B, the shapes in
/// the order of the call; Bullet's points from B to A.
void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output);

/// Puts the points that carried more in the last step first. Bullet's contact solver goes through a manifold in this
/// order, and its last word is the last point's: where that is one that carries much, the tilt that each level of a
/// tower is left with feeds a sway. By measurement (contact_report): the bodies of scenes/tower_20.json move at 90 mm/s
/// without this, at 1.4 with it (float; double 94, 0.5; no resting contacts kept). For manifolds that this pair owns
/// only.
void OrderByImpulse(btPersistentManifold& manifold);

/// Removes points whose distance, after a refresh, is no finite number: of bodies whose pose is no pose.
void DropPointsNotFinite(btPersistentManifold& manifold);

}  // namespace dgd_bullet
