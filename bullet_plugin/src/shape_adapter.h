// From a Bullet convex shape to the solver's set: the geometry that Bullet's own GJK sees, core plus margin.
#pragma once

#include <memory>
#include <variant>

#include "bullet_conversions.h"
#include "bullet_core.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"
#include "hull_cache.h"

namespace dgd_bullet {

/// The types of sets a Bullet shape can be. The pair is dispatched on once a query, in SolvePair().
using ShapeSet = std::variant<dgd::RoundedSet<dgd::Point<double>>, dgd::RoundedSet<dgd::Segment<double>>,
                              dgd::RoundedSet<dgd::Triangle<double>>, dgd::RoundedSet<dgd::Box<double>>,
                              dgd::RoundedSet<dgd::Cylinder<double>>, dgd::RoundedSet<dgd::Cone<double>>,
                              dgd::RoundedSet<dgd::CoreReference<dgd::Polytope<double>>>, dgd::RoundedSet<BulletCore>>;

/// A shape in a pose, for one query.
struct PosedShape {
  ShapeSet set;
  Pose pose;  ///< Of the set's own frame (z is the axis of round shapes) in the world.
};

/// Reads a shape. `hull` keeps the hull of point shapes from one call to the next, and is looked up in `cache` when it
/// is not this shape's, as it is now.
/// Throws std::invalid_argument if a size or a point is not finite or the shape has no points.
PosedShape AdaptShape(const btConvexShape& shape, const btTransform& transform, HullCache& cache,
                      std::shared_ptr<const CachedHull>& hull);

}  // namespace dgd_bullet
