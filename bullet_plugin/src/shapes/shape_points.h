// The points of the Bullet shapes that are hulls of points, scaled as Bullet's own support functions scale them.
#pragma once

#include <cstddef>
#include <vector>

#include "bullet_conversions.h"
#include "dgd_bullet/linkage.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether the shape is the hull of points, with a radius: hull, point cloud, tetrahedron, convex triangle mesh, and
/// spheres of one radius.
bool IsHullOfPoints(const btConvexShape& shape);

/// Random access to the points of a shape for which IsHullOfPoints() holds; valid while the shape is not changed.
class ShapePoints {
 public:
  explicit ShapePoints(const btConvexShape& shape);

  int Count() const { return count_; }
  Vector3 operator[](int i) const;
  const btVector3& Scaling() const { return *scaling_; }

  /// The points as they lie in memory, ByteSize() bytes before scaling; null where they are not an array of btVector3.
  const unsigned char* Bytes() const { return is_vector_array_ ? base_ : nullptr; }
  std::size_t ByteSize() const { return static_cast<std::size_t>(count_) * static_cast<std::size_t>(stride_); }

 private:
  const btConvexShape& shape_;
  const unsigned char* base_ = nullptr;  // Of the points, for the types that keep them in an array.
  int stride_ = 0;                       // Bytes.
  bool is_vector_array_ = false;         // Else the vertex buffer of somebody's mesh.
  bool is_double_ = false;
  int count_ = 0;
  const btVector3* scaling_;
};

/// All points of the shape that belong to its hull.
std::vector<Vector3> AllPoints(const btConvexShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
