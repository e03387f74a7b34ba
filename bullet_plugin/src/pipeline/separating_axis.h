// Whether bodies that were apart still are: the answer to most pairs of a broadphase, from as little as can tell.
//
// Bullet's own support functions, called for one direction, are exact but for the rounding of its precision, for which
// there is room between bodies that are apart. Nothing else of the shapes is read, and nothing that was kept of them
// has to be compared with what they are now: in a heap of thousands, memory is what pairs wait for.
#pragma once

#include <LinearMath/btVector3.h>

#include "dgd_bullet/linkage.h"

struct btCollisionObjectWrapper;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct BodyReach;

/// A convex shape where it is now, as part of a body or as all of it.
struct PlacedShape {
  const btCollisionObjectWrapper& wrapper;
  const BodyReach& body;
};

/// How far two convex shapes, with their margins, are at least apart along a direction; metres, rounding allowed for.
/// Minus infinity where that would take longer than the solver, of large hulls and of convex meshes; and of what is
/// no shape or no pose.
/// @param normal  From A to B, of unit length within rounding, world.
double SeparationAlong(const PlacedShape& shape_a, const PlacedShape& shape_b, const btVector3& normal);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
