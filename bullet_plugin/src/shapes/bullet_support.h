// Any convex Bullet shape through its own virtual support function: multi-spheres, scaled shapes, users' shapes.
#pragma once

#include "dgd/shapes/custom_core.h"
#include "dgd_bullet/linkage.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Keeps nothing of the shape from one query to the next, so that it cannot be out of date. The shape must outlive it.
/// The centre is the mean of the support points along the axes. An inradius is only computed for a `radius` of 0, from
/// the hull of those points: a rounded set needs none.
/// @param radius  That the core is rounded by, metres.
dgd::CustomCore CustomSupport(const btConvexShape& shape, double radius);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
