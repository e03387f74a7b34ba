#include "plugin/swept_shape.h"

namespace dgd_test {

SweptShape::SweptShape(const btConvexShape& shape, const btTransform& way) : shape_(shape), way_(way) {
  m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
}

btVector3 SweptShape::localGetSupportingVertex(const btVector3& direction) const {
  ++evaluations_;
  const btVector3 from = shape_.localGetSupportingVertex(direction);
  const btVector3 to = way_ * shape_.localGetSupportingVertex(direction * way_.getBasis());
  return direction.dot(from) > direction.dot(to) ? from : to;
}

btVector3 SweptShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  return localGetSupportingVertex(direction);
}

void SweptShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                                   int count) const {
  for (int i = 0; i < count; ++i) supports[i] = localGetSupportingVertex(directions[i]);
}

void SweptShape::getAabb(const btTransform& pose, btVector3& low, btVector3& high) const {
  btVector3 low_to, high_to;
  shape_.getAabb(pose, low, high);
  shape_.getAabb(pose * way_, low_to, high_to);
  low.setMin(low_to);
  high.setMax(high_to);
}

void SweptShape::getAabbSlow(const btTransform& pose, btVector3& low, btVector3& high) const {
  getAabb(pose, low, high);
}

const btVector3& SweptShape::getLocalScaling() const {
  static const btVector3 unscaled(1, 1, 1);
  return unscaled;
}

}  // namespace dgd_test
