// Bullet's shapes as the oracle sees them, regardless of the program that made them.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <optional>

#include "simulation/penetration_oracle.h"

namespace dgd_demos {

/// The shape in its own frame, with its scaling, by the geometry that RoundingRadius() and CoreOf() describe. Hulls may
/// have 400 vertices, since the oracle compares all edges with all.
/// @return none for what has no such core, or none that is solid: multi-spheres of different radii, flat hulls, and
///         Bullet's rarer types.
std::optional<RoundedPolyhedron> RoundedCoreOf(const btConvexShape& shape);

/// Planes as half-spaces, compounds by their children. A body with any part that has no such core is not judged at all.
OracleBody OracleBodyOf(const btCollisionShape& shape);

}  // namespace dgd_demos
