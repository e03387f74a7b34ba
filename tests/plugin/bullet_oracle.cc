#include "plugin/bullet_oracle.h"

#include "support/distance_bounds.h"

namespace dgd_test {

btTransform MakeTransform(const Eigen::Matrix3d& rotation, const Vector& translation) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    basis[row].setValue(btScalar(rotation(row, 0)), btScalar(rotation(row, 1)), btScalar(rotation(row, 2)));
  }
  return btTransform(basis, ToBullet(translation));
}

Vector PosedConvex::CoreSupport(const Vector& direction) const {
  Eigen::Matrix3d rotation;
  for (int row = 0; row < 3; ++row) rotation.row(row) = ToEigen(pose.getBasis()[row]);
  const Vector local = rotation.transpose() * direction.normalized();
  return rotation * ToEigen(shape.localGetSupportVertexWithoutMarginNonVirtual(ToBullet(local))) +
         ToEigen(pose.getOrigin());
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
