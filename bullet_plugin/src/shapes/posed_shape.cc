#include "shapes/posed_shape.h"

#include <cmath>

#include "dgd/assert.h"

namespace dgd_bullet {
namespace {

void MoveCenterNear(const Vector3& point, PosedShape& shape) {
  shape.set.MoveCenterNear(shape.pose.rotation.transpose() * (point - shape.pose.translation));
}

}  // namespace

Vector3 CenterOf(const PosedShape& shape) { return shape.pose * shape.set.Center(); }

Vector3 SupportPoint(const PosedShape& shape, const Vector3& direction) {
  DGD_ASSERT(!(std::abs(direction.squaredNorm() - 1) > 1e-3));
  const Vector3 local = shape.pose.rotation.transpose() * direction;
  return shape.pose * shape.set.CoreSupport(local) + shape.set.Radius() * direction;
}

void MoveCentersTogether(PosedShape& shape_a, PosedShape& shape_b) {
  // Both from where they were, so that the order of the two does not matter.
  const Vector3 center_a = CenterOf(shape_a), center_b = CenterOf(shape_b);
  MoveCenterNear(center_b, shape_a);
  MoveCenterNear(center_a, shape_b);
}

}  // namespace dgd_bullet
