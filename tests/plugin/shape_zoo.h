// One Bullet shape of every convex type, and the variants of them that Bullet treats apart: axes, scalings, margins.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include <memory>
#include <string>
#include <vector>

#include "support/random.h"

class btConvexHullShape;

namespace dgd_test {

/// A shape and what it refers to but does not own (mesh data, the points of a cloud, the child of a scaling).
struct ZooShape {
  std::string name;
  std::vector<std::shared_ptr<void>> kept_alive;
  std::shared_ptr<btConvexShape> shape;
  bool is_smooth = false;  ///< Its core is curved: nothing ends at rounding error.
};

/// All of them, about `size` metres across, with margins of a few hundredths of that.
std::vector<ZooShape> MakeShapeZoo(double size);

/// Names only, for parameterized tests; those of MakeShapeZoo() in its order.
const std::vector<std::string>& ShapeZooNames();

/// Hull of `count` points near a sphere of the given diameter.
std::shared_ptr<btConvexHullShape> MakeRandomHull(Random& random, int count, double diameter);

/// Hull of a regular prism about the z axis.
std::shared_ptr<btConvexHullShape> MakePrism(int sides, double radius, double half_height);

/// A user's own convex shape, known to Bullet by its virtual support function alone: an ellipsoid.
class Ellipsoid : public btConvexInternalShape {
 public:
  explicit Ellipsoid(const btVector3& half_axes);

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                         int count) const override;
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
  const char* getName() const override { return "Ellipsoid"; }

 private:
  btVector3 half_axes_;
};

}  // namespace dgd_test
