// Whether a shape is the one that it was.
//
// Bullet reports to nobody when a shape changes or dies, and a new one may take its address: what depends on a shape
// from one step to the next compares the numbers that make the shape what it is.
#pragma once

#include <LinearMath/btScalar.h>

#include <array>
#include <memory>

#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"

class btCollisionShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ShapeIdentity {
 public:
  /// Type, axis, three sizes and the offset of the surface from them; all that makes a shape but the points of a hull.
  using Numbers = std::array<btScalar, 6>;

  /// Whether a shape is of a type whose numbers can be compared.
  static bool IsComparable(const btCollisionShape& shape);

  /// @param shape  A comparable one.
  explicit ShapeIdentity(const btCollisionShape& shape);

  /// Whether a shape is the one that this was made from, unchanged.
  /// @param hull  The cached hull of a hull of points, whose points that compares; else unused.
  bool Matches(const btCollisionShape& shape, const std::shared_ptr<const CachedHull>& hull) const;

  const Numbers& numbers() const { return numbers_; }

 private:
  const btCollisionShape* shape_;
  Numbers numbers_;
};

/// Whether the set that a shape becomes shows its faces, as those of planes and meshes do. Shapes that only Bullet can
/// evaluate do not: unequal spheres, scaled shapes, an app's own.
bool ShowsFaces(const btCollisionShape& shape);

/// Whether a shape does not roll: a polytope with a margin, or a half-space.
bool IsPolytope(const btCollisionShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
