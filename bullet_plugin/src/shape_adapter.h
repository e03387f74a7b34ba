// From a Bullet convex shape to the solver's set: the geometry that Bullet's own GJK sees, core plus margin.
#pragma once

#include <memory>

#include "bullet_conversions.h"
#include "hull_cache.h"
#include "posed_shape.h"

class btConvexShape;

namespace dgd_bullet {

/// Reads a shape. `hull` keeps the hull of point shapes from one call to the next, and is looked up in `cache` when it
/// is not this shape's, as it is now.
/// Throws std::invalid_argument if a size or a point is not finite or the shape has no points.
PosedShape AdaptShape(const btConvexShape& shape, const btTransform& transform, HullCache& cache,
                      std::shared_ptr<const CachedHull>& hull);

}  // namespace dgd_bullet
