// Any convex Bullet shape through its own virtual support function: multi-spheres, scaled shapes, users' shapes.
#pragma once

#include "support_core.h"

class btConvexShape;

namespace dgd_bullet {

/// Keeps nothing of the shape from one query to the next, so that it cannot be out of date. The shape must outlive it.
/// The centre is the mean of the support points along the axes. An inradius is only computed for shapes without a
/// margin, from the hull of those points: with one, the solver needs none.
SupportCore ThroughBullet(const btConvexShape& shape);

}  // namespace dgd_bullet
