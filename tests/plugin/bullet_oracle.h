// What Bullet itself says of its shapes, in double: support values and exact distances from Bullet's own support
// functions; of boxes, what is documented (dgd_bullet::GeometryMode). Shares no code with the narrowphase under test.
#pragma once

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btTransform.h>

#include <Eigen/Core>

namespace dgd_test {

using Vector = Eigen::Vector3d;

inline Vector ToEigen(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }
inline btVector3 ToBullet(const Vector& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }
btTransform MakeTransform(const Eigen::Matrix3d& rotation, const Vector& translation);
/// Not turned.
inline btTransform At(double x, double y, double z) { return MakeTransform(Eigen::Matrix3d::Identity(), {x, y, z}); }

/// A convex shape in a pose, as Bullet's GJK sees it, core plus margin; a box of full size, sharp. Refers to
/// both.
struct PosedConvex {
  const btConvexShape& shape;
  const btTransform& pose;

  /// Core point farthest along a world direction, world.
  Vector CoreSupport(const Vector& direction) const;
  double Margin() const;
  /// Largest <direction, x> over core plus margin; `direction` has unit length.
  double SupportValue(const Vector& direction) const;
};

/// Distance of the supporting planes along `normal`, a unit vector from B to A; negative for overlap along it.
double PlaneSeparation(const PosedConvex& a, const PosedConvex& b, const Vector& normal_b_to_a);

/// Signed distance of two shapes: of their surfaces where they are apart, minus the least translation that parts them
/// where they overlap. Between `value` and `upper`, which are equal up to rounding but for flat shapes inside each
/// other.
struct SignedDistance {
  double value = 0;               ///< Proven by the supporting planes along `normal_b_to_a`.
  double upper = 0;               ///< Proven by points of the shapes.
  Vector normal_b_to_a{0, 0, 0};  ///< Unit.
};
SignedDistance DistanceOfShapes(const PosedConvex& a, const PosedConvex& b);

/// Signed distance of a world point to a shape (core plus margin); where the core is flat and holds the point, minus
/// the margin.
double Outside(const PosedConvex& shape, const Vector& point);

}  // namespace dgd_test
