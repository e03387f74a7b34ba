// A convex shape of an app's own with flat faces, which only its support function shows.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

namespace dgd_test {

/// It stands on its larger face, and all within the margin of it.
class TruncatedPyramid : public btConvexInternalShape {
 public:
  /// @param half    Half the size of the larger face, and half the height, without the margin; metres.
  /// @param margin  Metres.
  TruncatedPyramid(const btVector3& half, double margin);

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* points,
                                                         int count) const override;
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
  const char* getName() const override { return "TruncatedPyramid"; }

 private:
  btVector3 half_;
};

}  // namespace dgd_test
