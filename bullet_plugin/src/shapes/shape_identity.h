// Whether a shape is the one that it was.
//
// Bullet reports to nobody when a shape changes or dies, and a new one may take its address: what depends on a shape
// from one step to the next compares the numbers that make the shape what it is.
#pragma once

#include <LinearMath/btVector3.h>

#include <memory>

#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"

class btCollisionShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ShapeIdentity {
 public:
  /// Whether a shape is of a type whose numbers can be compared.
  static bool IsComparable(const btCollisionShape& shape);

  /// @param shape  A comparable one.
  explicit ShapeIdentity(const btCollisionShape& shape);

  /// Whether a shape is where this was made from, of the same type and with the same margin.
  bool HasMarginOf(const btCollisionShape& shape) const;

  /// Whether a shape is the one that this was made from, unchanged.
  /// @param hull  The cached hull of a hull of points, whose points that compares; else unused.
  bool Matches(const btCollisionShape& shape, const std::shared_ptr<const CachedHull>& hull) const;

 private:
  const btCollisionShape* shape_;
  int type_;
  int axis_;  // Another shape of the same size may have taken the address.
  btVector3 size_;
  btScalar offset_;  // The margin, or a plane's constant.
};

/// Whether a shape does not roll: a polytope with a margin, or a half-space.
bool IsPolytope(const btCollisionShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
