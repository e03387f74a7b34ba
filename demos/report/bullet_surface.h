// Surfaces of Bullet's collision shapes, for pictures.
#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <Eigen/Core>

#include "render/surface_mesh.h"

namespace dgd_demos {

/// What is drawn of an infinite plane: a square, m, in the frame of the shape.
struct PlaneSquare {
  Eigen::Vector3d middle;  ///< Its projection onto the plane is the middle of the square.
  double half_size;
};

/// The shape with its scaling and margin, in its own frame: convex shapes and compounds of them by the geometry of
/// RoundedCoreOf(); what has none by a hull of about a thousand of its support points. Triangles of meshes have two
/// sides, and no margin. Planes are seen from above alone.
SurfaceMesh SurfaceOf(const btCollisionShape& shape, const PlaneSquare& square);

}  // namespace dgd_demos
