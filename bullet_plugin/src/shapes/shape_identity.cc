#include "shapes/shape_identity.h"

#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include "dgd/assert.h"
#include "shapes/multi_sphere.h"
#include "shapes/shape_adapter.h"
#include "shapes/shape_points.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// The numbers that make a shape what it is, besides its margin; none of a hull of points, whose hull is compared.
btVector3 SizeOf(const btCollisionShape& shape, int type) {
  switch (type) {
    case STATIC_PLANE_PROXYTYPE:
      return static_cast<const btStaticPlaneShape&>(shape).getPlaneNormal();
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      return {cone.getRadius(), cone.getHeight(), 0};
    }
    case SPHERE_SHAPE_PROXYTYPE:
    case BOX_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
      return static_cast<const btConvexInternalShape&>(shape).getImplicitShapeDimensions();
    default:
      return {0, 0, 0};
  }
}

/// How far the surface is outside of what SizeOf() describes.
btScalar OffsetOf(const btCollisionShape& shape, int type) {
  switch (type) {
    case STATIC_PLANE_PROXYTYPE:  // A plane's margin has no effect.
      return static_cast<const btStaticPlaneShape&>(shape).getPlaneConstant();
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return btScalar(SmallestRadius(static_cast<const btMultiSphereShape&>(shape)));
    default:
      return shape.getMargin();
  }
}

int AxisOf(const btCollisionShape& shape, int type) {
  return type == STATIC_PLANE_PROXYTYPE ? kZAxis : UpAxis(static_cast<const btConvexShape&>(shape));
}

}  // namespace

bool ShapeIdentity::IsComparable(const btCollisionShape& shape) {
  const int type = shape.getShapeType();
  return type == CONE_SHAPE_PROXYTYPE || type == SPHERE_SHAPE_PROXYTYPE || type == BOX_SHAPE_PROXYTYPE ||
         type == CAPSULE_SHAPE_PROXYTYPE || type == CYLINDER_SHAPE_PROXYTYPE || type == STATIC_PLANE_PROXYTYPE ||
         IsHullOfPoints(static_cast<const btConvexShape&>(shape));
}

ShapeIdentity::ShapeIdentity(const btCollisionShape& shape)
    : shape_(&shape),
      type_(shape.getShapeType()),
      axis_(AxisOf(shape, type_)),
      size_(SizeOf(shape, type_)),
      offset_(OffsetOf(shape, type_)) {
  DGD_ASSERT(IsComparable(shape));
}

bool ShapeIdentity::HasMarginOf(const btCollisionShape& shape) const {
  return &shape == shape_ && shape.getShapeType() == type_ && OffsetOf(shape, type_) == offset_;
}

bool ShapeIdentity::Matches(const btCollisionShape& shape, const std::shared_ptr<const CachedHull>& hull) const {
  if (!HasMarginOf(shape)) return false;
  if (type_ != STATIC_PLANE_PROXYTYPE) {
    const auto& convex = static_cast<const btConvexShape&>(shape);
    if (IsHullOfPoints(convex)) return hull != nullptr && hull->Matches(convex);
  }
  return AxisOf(shape, type_) == axis_ && SizeOf(shape, type_) == size_;
}

bool IsPolytope(const btCollisionShape& shape) {
  const int type = shape.getShapeType();
  if (type == BOX_SHAPE_PROXYTYPE || type == STATIC_PLANE_PROXYTYPE) return true;
  return type != MULTI_SPHERE_SHAPE_PROXYTYPE && IsHullOfPoints(static_cast<const btConvexShape&>(shape));
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
