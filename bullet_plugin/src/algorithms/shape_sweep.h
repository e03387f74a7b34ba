// The time of impact of two of Bullet's convex shapes that move from one pose to another.
#pragma once

#include <memory>

#include "dgd/time_of_impact.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "shapes/hull_cache.h"

class btConvexShape;
class btTransform;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A shape and its way.
struct MovingShape {
  const btConvexShape& shape;
  const btTransform& from;
  const btTransform& to;
  std::shared_ptr<const CachedHull>& hull;  ///< See AdaptShape().
};

/// kInvalidInput if a shape is none. Does not throw.
dgd::TimeOfImpactResult<double> SweepShapes(const MovingShape& a, const MovingShape& b, GeometryMode geometry,
                                            HullCache& cache, HullUse use);

/// Whether the result is that the shapes meet, or may: what a sweep could not decide counts as met, since a body that
/// stops early is seen, and one that is let through is lost. Shapes that touch from the start and move apart do not
/// meet, as in Bullet's own sweeps.
bool Meet(const dgd::TimeOfImpactResult<double>& result, const MovingShape& a, const MovingShape& b);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
