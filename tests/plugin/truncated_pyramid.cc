#include "plugin/truncated_pyramid.h"

namespace dgd_test {
namespace {

/// Size of the upper face, over that of the lower.
constexpr btScalar kTaper = btScalar(0.6);

btVector3 CornerTowards(const btVector3& direction, const btVector3& half) {
  return {direction.x() < 0 ? -half.x() : half.x(), direction.y() < 0 ? -half.y() : half.y(), half.z()};
}

}  // namespace

TruncatedPyramid::TruncatedPyramid(const btVector3& half, double margin) : half_(half) {
  m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  setMargin(btScalar(margin));
}

btVector3 TruncatedPyramid::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  const btVector3 lower = CornerTowards(direction, btVector3(half_.x(), half_.y(), -half_.z()));
  const btVector3 upper = CornerTowards(direction, btVector3(kTaper * half_.x(), kTaper * half_.y(), half_.z()));
  return direction.dot(upper) > direction.dot(lower) ? upper : lower;
}

void TruncatedPyramid::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* points,
                                                                         int count) const {
  for (int i = 0; i < count; ++i) points[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void TruncatedPyramid::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
  // That of the box around it.
  const btVector3 side = 2 * (half_ + btVector3(getMargin(), getMargin(), getMargin())), squares = side * side;
  inertia = mass / 12 * btVector3(squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y());
}

}  // namespace dgd_test
