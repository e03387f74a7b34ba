// A convex shape swept from one pose to another, as motion planners have it: known to Bullet by its support function
// alone, without a margin.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

namespace dgd_test {

/// The hull of a shape in two poses. Counts how often it is evaluated.
class SweptShape : public btConvexShape {
 public:
  /// @param shape  Outlives this.
  /// @param way    From the first pose to the second, in the shape's frame.
  SweptShape(const btConvexShape& shape, const btTransform& way);

  const btConvexShape& shape() const { return shape_; }
  const btTransform& way() const { return way_; }
  int Evaluations() const { return evaluations_; }

  btVector3 localGetSupportingVertex(const btVector3& direction) const override;
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                         int count) const override;
  void getAabb(const btTransform& pose, btVector3& low, btVector3& high) const override;
  void getAabbSlow(const btTransform& pose, btVector3& low, btVector3& high) const override;
  void setLocalScaling(const btVector3&) override {}
  const btVector3& getLocalScaling() const override;
  void setMargin(btScalar) override {}
  btScalar getMargin() const override { return 0; }
  int getNumPreferredPenetrationDirections() const override { return 0; }
  void getPreferredPenetrationDirection(int, btVector3& direction) const override { direction.setZero(); }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "Swept"; }

 private:
  const btConvexShape& shape_;
  const btTransform way_;
  mutable int evaluations_ = 0;
};

}  // namespace dgd_test
