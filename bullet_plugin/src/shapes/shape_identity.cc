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

ShapeIdentity::Numbers NumbersOf(const btCollisionShape& shape) {
  const int type = shape.getShapeType();
  const int axis = type == STATIC_PLANE_PROXYTYPE ? kZAxis : UpAxis(static_cast<const btConvexShape&>(shape));
  btVector3 size(0, 0, 0);
  btScalar offset = shape.getMargin();
  switch (type) {
    case STATIC_PLANE_PROXYTYPE:  // A plane's margin has no effect.
      size = static_cast<const btStaticPlaneShape&>(shape).getPlaneNormal();
      offset = static_cast<const btStaticPlaneShape&>(shape).getPlaneConstant();
      break;
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      size = {cone.getRadius(), cone.getHeight(), 0};
      break;
    }
    case SPHERE_SHAPE_PROXYTYPE:
    case BOX_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
      size = static_cast<const btConvexInternalShape&>(shape).getImplicitShapeDimensions();
      break;
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      offset = btScalar(SmallestRadius(static_cast<const btMultiSphereShape&>(shape)));
      break;
    default:
      break;
  }
  return {btScalar(type), btScalar(axis), size.x(), size.y(), size.z(), offset};
}

}  // namespace

bool ShapeIdentity::IsComparable(const btCollisionShape& shape) {
  const int type = shape.getShapeType();
  return type == CONE_SHAPE_PROXYTYPE || type == SPHERE_SHAPE_PROXYTYPE || type == BOX_SHAPE_PROXYTYPE ||
         type == CAPSULE_SHAPE_PROXYTYPE || type == CYLINDER_SHAPE_PROXYTYPE || type == STATIC_PLANE_PROXYTYPE ||
         IsHullOfPoints(static_cast<const btConvexShape&>(shape));
}

ShapeIdentity::ShapeIdentity(const btCollisionShape& shape) : shape_(&shape), numbers_(NumbersOf(shape)) {
  DGD_ASSERT(IsComparable(shape));
}

bool ShapeIdentity::Matches(const btCollisionShape& shape, const std::shared_ptr<const CachedHull>& hull) const {
  // Another shape of another type may have taken the address, for which NumbersOf() has no numbers.
  if (&shape != shape_ || !IsComparable(shape) || NumbersOf(shape) != numbers_) return false;
  if (!shape.isConvex()) return true;
  const auto& convex = static_cast<const btConvexShape&>(shape);
  return !IsHullOfPoints(convex) || (hull != nullptr && hull->Matches(convex));
}

bool ShowsFaces(const btCollisionShape& shape) {
  return !shape.isConvex() || shape.getShapeType() == TRIANGLE_SHAPE_PROXYTYPE || ShapeIdentity::IsComparable(shape);
}

bool IsPolytope(const btCollisionShape& shape) {
  const int type = shape.getShapeType();
  if (type == BOX_SHAPE_PROXYTYPE || type == STATIC_PLANE_PROXYTYPE) return true;
  return type != MULTI_SPHERE_SHAPE_PROXYTYPE && IsHullOfPoints(static_cast<const btConvexShape&>(shape));
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
