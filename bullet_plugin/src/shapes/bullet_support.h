// Any convex Bullet shape through its own virtual support function: multi-spheres, scaled shapes, users' shapes.
#pragma once

#include "dgd/shapes/custom_core.h"
#include "dgd_bullet/linkage.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Keeps nothing of the shape from one query to the next, so that it cannot be out of date. The shape must outlive it.
/// The centre is the mean of six support points, and the inradius that of their hull: a rounded set needs none.
/// @param radius           That the core is rounded by, metres.
/// @param is_for_distance  Whether only a signed distance is wanted, which needs neither: the centre is the frame's
///                         origin then, without any support point.
dgd::CustomCore CustomSupport(const btConvexShape& shape, double radius, bool is_for_distance);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
