// The second stage of a pair: whether bodies that were apart still are. It is the result for most pairs of a
// broadphase, and reads as little as it can.
//
// Bullet's own support functions, evaluated for one direction, are exact but for the roundoff of its precision, for
// which there is room between bodies that are apart. Nothing else of the shapes is read, and nothing cached of them has
// to be compared with what they are now: in a heap of thousands, memory is what pairs wait for.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include "dgd_bullet/linkage.h"
#include "pair_motion.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A convex shape where it is now, as part of a body or as all of it.
struct PlacedShape {
  const btCollisionObjectWrapper& wrapper;
  const BoundedBody& body;
};

/// A lower bound of the distance of two convex shapes, with their margins, along a direction; metres, with allowance
/// for roundoff. Minus infinity where that would take longer than the solver, for large hulls and convex meshes; and
/// for what is no shape or no pose.
/// @param normal  From A to B, of unit length within roundoff, world.
double SeparationAlong(const PlacedShape& shape_a, const PlacedShape& shape_b, const btVector3& normal);

/// Larger hulls are left to the solver, which climbs them. A point takes up to 12 instructions here, on either side;
/// the solver takes 2000 in all (callgrind, hulls of 8 to 20 points).
constexpr int kMaxScannedPoints = 64;

/// The result of a pair that the cached axis separates.
constexpr PairOutcome kApart{.iterations = 1, .stage = PairOutcome::Stage::kSeparated};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
