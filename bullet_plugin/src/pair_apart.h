// Whether bodies that were apart still are: the answer to most pairs of a broadphase, from as little as can tell.
//
// Bullet's own support functions, called for one direction, are exact but for the rounding of its precision, for which
// there is room between bodies that are apart. Nothing else of the shapes is read, and nothing that was kept of them
// has to be compared with what they are now: in a heap of thousands, memory is what pairs wait for.
#pragma once

#include "solver_types.h"

struct btCollisionObjectWrapper;

namespace dgd_bullet {

/// Whether two convex shapes, with their margins, are farther apart along a normal than `limit`, metres. False where
/// that would take longer than the solver: of large hulls, and of meshes.
/// @param normal  Unit, from A to B, world.
bool AreApart(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b, const Vector3& normal,
              double limit);

}  // namespace dgd_bullet
