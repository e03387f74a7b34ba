// What Bullet itself says of its shapes, in double: support values and exact distances from Bullet's own support
// functions. Shares no code with the narrowphase under test.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <LinearMath/btTransform.h>

#include <Eigen/Core>

namespace dgd_test {

using Vector = Eigen::Vector3d;

inline Vector ToEigen(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }
inline btVector3 ToBullet(const Vector& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }
btTransform MakeTransform(const Eigen::Matrix3d& rotation, const Vector& translation);

/// A convex shape in a pose, as Bullet's GJK sees it: core plus margin. Refers to both.
struct PosedConvex {
  const btConvexShape& shape;
  const btTransform& pose;

  /// Core point farthest along a world direction, world.
  Vector CoreSupport(const Vector& direction) const;
  double Margin() const { return double(shape.getMarginNonVirtual()); }
  /// Largest <direction, x> over core plus margin; `direction` has unit length.
  double SupportValue(const Vector& direction) const;
};

/// Distance of the supporting planes along `normal`, a unit vector from B to A; negative for overlap along it.
double PlaneSeparation(const PosedConvex& a, const PosedConvex& b, const Vector& normal_b_to_a);

/// Distance of two cores with what is known of it. Zero where they overlap.
struct CoreDistance {
  double upper = 0;               ///< Of two points of the cores.
  double lower = 0;               ///< Proven by the supporting planes along `normal`.
  Vector normal_b_to_a{0, 0, 0};  ///< Unit, or zero where the cores overlap.
};
CoreDistance DistanceOfCores(const PosedConvex& a, const PosedConvex& b);

/// Signed distance of the two shapes, exact while their cores are disjoint; where they are not, all that is known is
/// that it is at most minus the two margins.
struct SignedDistance {
  double value = 0;
  bool exact = false;
  Vector normal_b_to_a{0, 0, 0};  ///< Valid if exact.
};
SignedDistance DistanceOfShapes(const PosedConvex& a, const PosedConvex& b);

/// How far a world point is outside a shape (core plus margin); negative inside, where only its sign is exact beyond
/// the margin's depth.
double Outside(const PosedConvex& shape, const Vector& point);

}  // namespace dgd_test
