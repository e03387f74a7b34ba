// The convex shapes a scene is made of, as values. All are centred at their local origin; axes are along local z.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "scene/polyhedron.h"

namespace dgd_demos {

struct Sphere {
  double radius;  ///< m
};
struct Capsule {
  double radius;  ///< m
  double length;  ///< Of the axis between the two half spheres, m.
};
struct Box {
  Eigen::Vector3d half_extents;  ///< m
};
struct Cylinder {
  double radius;  ///< m
  double height;  ///< m
};
struct Cone {
  double radius;  ///< Of the base, m.
  double height;  ///< m; the local origin is at half height, as in Bullet.
};
struct Hull {
  Polyhedron polyhedron;
};

using Shape = std::variant<Sphere, Capsule, Box, Cylinder, Cone, Hull>;

/// What Bullet is told to be the shape's margin: the one asked for; of boxes and cylinders a tenth of their least half
/// extent at most (btConvexInternalShape's setSafeMargin). That of spheres and capsules is their radius.
double BulletMargin(const Shape& shape, double margin);

/// The collision geometry is a core plus a ball. Hulls and cones grow by the whole margin; cylinders keep their size
/// and get round edges of Bullet's margin; boxes keep theirs, with edges as good as sharp: of a 512th of their least
/// half extent at most; for spheres and capsules the ball is their radius.
/// @return radius of the ball, m.
double RoundingRadius(const Shape& shape, double margin);

/// The shape without its ball; cylinders and cones as prisms and pyramids of kCircleSides sides, inscribed. Their
/// surface is therefore up to radius * (1 - cos(pi / kCircleSides)), 0.12 % of the radius, inside the true one.
Polyhedron CoreOf(const Shape& shape, double margin);
inline constexpr int kCircleSides = 64;

/// Radius of the ball about the local origin that contains the shape with its margin, m.
double BoundingRadius(const Shape& shape, double margin);

}  // namespace dgd_demos
