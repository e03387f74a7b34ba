// Scene shapes as Bullet shapes.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>

#include "scene/shape.h"

namespace dgd_demos {

/// The Bullet shape with the geometry that RoundingRadius() and CoreOf() describe; of boxes, that is what the growth
/// distance makes of it.
std::unique_ptr<btConvexShape> MakeBulletShape(const Shape& shape, double margin);

}  // namespace dgd_demos
