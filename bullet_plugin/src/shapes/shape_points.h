// The points of the Bullet shapes that are hulls of points, scaled as Bullet's own support functions scale them.
#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <cstddef>
#include <span>
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
  /// How the points lie in memory.
  struct Layout {
    bool operator==(const Layout&) const = default;

    int count = 0, stride = sizeof(btVector3);  // The stride is in bytes.
    bool is_double = sizeof(btScalar) == sizeof(double);
  };

  explicit ShapePoints(const btConvexShape& shape);
  ShapePoints(const ShapePoints&) = delete;
  ShapePoints& operator=(const ShapePoints&) = delete;

  int Count() const { return layout_.count; }
  Vector3 operator[](int i) const;
  const btVector3& Scaling() const { return *scaling_; }
  const Layout& layout() const { return layout_; }
  /// The points before scaling, from the first one's beginning to the last one's end.
  std::span<const unsigned char> Bytes() const;

 private:
  Layout layout_;
  const unsigned char* base_ = nullptr;
  const btVector3* scaling_;
  std::array<btVector3, 4> corners_;  // Those of a tetrahedron, which has no array.
};

/// All points of the shape that belong to its hull.
std::vector<Vector3> AllPoints(const btConvexShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
