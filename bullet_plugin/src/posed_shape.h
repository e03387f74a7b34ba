// The sets that Bullet's convex shapes become. Free of Bullet: what is built on it alone serves both precisions.
#pragma once

#include <variant>

#include "dgd/convex_set.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"
#include "solver_types.h"
#include "support_core.h"

namespace dgd_bullet {

/// In the order of Bullet's types, of which ComesBefore() takes the lower one first.
using ShapeSet =
    std::variant<dgd::RoundedSet<dgd::Box<double>>, dgd::RoundedSet<dgd::Triangle<double>>,
                 dgd::RoundedSet<dgd::CoreReference<dgd::Polytope<double>>>, dgd::RoundedSet<dgd::Point<double>>,
                 dgd::RoundedSet<dgd::Segment<double>>, dgd::RoundedSet<dgd::Cone<double>>,
                 dgd::RoundedSet<dgd::Cylinder<double>>, dgd::RoundedSet<SupportCore>>;

/// A shape in a pose, for one query.
struct PosedShape {
  ShapeSet set;
  Pose pose;  ///< Of the set's own frame (z is the axis of round shapes) in the world.
};

/// Whether the solver is compiled for the two as they are: of a pair of types, one order is enough (pair_visit.h).
inline bool IsInOrder(const PosedShape& shape_a, const PosedShape& shape_b) {
  return shape_a.set.index() <= shape_b.set.index();
}

/// A point inside of the shape, or on it if it has no inside; world.
Vector3 CenterOf(const PosedShape& shape);

/// The farthest point of a shape along a direction of unit length; world.
Vector3 SupportPoint(const PosedShape& shape, const Vector3& direction);

/// Moves the shapes' centres near to each other, where their cores allow it (dgd::CenteredCore).
void MoveCentersTogether(PosedShape& shape_a, PosedShape& shape_b);

}  // namespace dgd_bullet
