// A set that a Bullet shape has become, in its place in the world. Free of Bullet: what is built on it alone serves
// both precisions.
#pragma once

#include "dgd/any_set.h"
#include "solver_types.h"

namespace dgd_bullet {

/// A shape in a pose, for one query.
struct PosedShape {
  dgd::AnySet set;
  Pose pose;  ///< Pose of the set's own frame (z is the axis of round shapes) in the world.
};

/// A point inside of the shape, or on it if it has no inside; world.
Vector3 CenterOf(const PosedShape& shape);

/// The farthest point of a shape along a direction of unit length; world.
Vector3 SupportPoint(const PosedShape& shape, const Vector3& direction);

/// Whether one of two shapes is a ball, and the other one a ball, a capsule or a triangle: the line of their centres is
/// the contact's, once MoveCentersTogether() has moved them.
bool TouchAlongCenters(const PosedShape& shape_a, const PosedShape& shape_b);

/// Their contact; kInvalidInput for coincident centres.
Contact ContactAlongCenters(const PosedShape& shape_a, const PosedShape& shape_b);

/// Moves the shapes' centres near to each other, where their cores allow it (dgd::CenteredCore).
void MoveCentersTogether(PosedShape& shape_a, PosedShape& shape_b);

}  // namespace dgd_bullet
