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

/// Hands the patch over. `normal` points from A to B, the shapes in the order of the call; Bullet's points from B to A.
void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output);

}  // namespace dgd_bullet
