#include "plugin/bullet_oracle.h"

#include <algorithm>
#include <cmath>

#include "support/distance_bounds.h"

namespace dgd_test {
namespace {

/// Null for all but boxes: not for a shape that is made of one.
const btBoxShape* AsBox(const btConvexShape& shape) {
  return shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? static_cast<const btBoxShape*>(&shape) : nullptr;
}

Vector HalfExtents(const btBoxShape& box) { return ToEigen(box.getHalfExtentsWithMargin()); }

/// The corner farthest along a direction of the box's frame.
Vector CornerAlong(const btBoxShape& box, const Vector& direction) {
  const Vector core = HalfExtents(box);
  return {std::copysign(core.x(), direction.x()), std::copysign(core.y(), direction.y()),
          std::copysign(core.z(), direction.z())};
}

}  // namespace

btTransform MakeTransform(const Eigen::Matrix3d& rotation, const Vector& translation) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    basis[row].setValue(btScalar(rotation(row, 0)), btScalar(rotation(row, 1)), btScalar(rotation(row, 2)));
  }
  return btTransform(basis, ToBullet(translation));
}

double PosedConvex::Margin() const {
  const btBoxShape* box = AsBox(shape);
  return box != nullptr ? 0 : double(shape.getMarginNonVirtual());
}

Vector PosedConvex::CoreSupport(const Vector& direction) const {
  Eigen::Matrix3d rotation;
  for (int row = 0; row < 3; ++row) rotation.row(row) = ToEigen(pose.getBasis()[row]);
  const Vector local = rotation.transpose() * direction.normalized();
  const btBoxShape* box = AsBox(shape);
  const Vector support = box != nullptr ? CornerAlong(*box, local)
                                        : ToEigen(shape.localGetSupportVertexWithoutMarginNonVirtual(ToBullet(local)));
  return rotation * support + ToEigen(pose.getOrigin());
}

double PosedConvex::SupportValue(const Vector& direction) const {
  return direction.dot(CoreSupport(direction)) + Margin();
}

double PlaneSeparation(const PosedConvex& a, const PosedConvex& b, const Vector& normal_b_to_a) {
  return -a.SupportValue(-normal_b_to_a) - b.SupportValue(normal_b_to_a);
}

SignedDistance DistanceOfShapes(const PosedConvex& a, const PosedConvex& b) {
  // The margins' balls add their radii to the least translation as they take them off the distance.
  const DistanceBounds cores = BoundDistanceToOrigin(
      [&](const Vector& direction) -> Vector { return a.CoreSupport(direction) - b.CoreSupport(-direction); });
  const double margins = a.Margin() + b.Margin();
  return {cores.lower - margins, cores.upper - margins, -cores.normal};
}

double Outside(const PosedConvex& shape, const Vector& point) {
  return BoundDistanceToOrigin([&](const Vector& direction) -> Vector {
           return shape.CoreSupport(direction) - point;
         }).upper -
         shape.Margin();
}

}  // namespace dgd_test
