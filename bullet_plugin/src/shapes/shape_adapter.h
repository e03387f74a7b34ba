// The solver's sets of Bullet's convex shapes.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "shapes/hull_cache.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A margin that is larger than a box or cylinder leaves Bullet a negative core, which is no set: its extent counts as
/// zero. NaN stays NaN, which the set rejects.
inline btScalar ClampHalfExtent(btScalar half_extent) { return half_extent < 0 ? btScalar(0) : half_extent; }

/// The convex shape of a body.
inline const btConvexShape& ConvexShapeOf(const btCollisionObjectWrapper& body) {
  DGD_ASSERT(body.getCollisionShape()->isConvex());
  return *static_cast<const btConvexShape*>(body.getCollisionShape());
}

/// Bullet's axis that is the z axis of the set that a shape becomes: a round shape's own, else z.
int UpAxis(const btConvexShape& shape);

/// The set of a shape in its pose.
/// @param geometry  What the shape's surface is.
/// @param hull      In and out: the hull of a hull of points from one call to the next; looked up in `cache` when it is
///                  not this shape's, as it is now.
/// @param use       Whose query the hull is for.
/// @param is_for_distance  See CustomSupport().
/// Throws std::invalid_argument if a size or a point is not finite or the shape has no points.
PosedShape AdaptShape(const btConvexShape& shape, const btTransform& transform, GeometryMode geometry, HullCache& cache,
                      std::shared_ptr<const CachedHull>& hull, HullUse use, bool is_for_distance = false);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
