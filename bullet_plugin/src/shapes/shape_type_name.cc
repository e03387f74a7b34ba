#include "shapes/shape_type_name.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

const char* ShapeTypeName(int type) {
  switch (type) {
    case BOX_SHAPE_PROXYTYPE:
      return "BOX";
    case TRIANGLE_SHAPE_PROXYTYPE:
      return "TRIANGLE";
    case TETRAHEDRAL_SHAPE_PROXYTYPE:
      return "TETRAHEDRAL";
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return "CONVEX_TRIANGLEMESH";
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return "CONVEX_HULL";
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
      return "CONVEX_POINT_CLOUD";
    case CUSTOM_POLYHEDRAL_SHAPE_TYPE:
      return "CUSTOM_POLYHEDRAL";
    case SPHERE_SHAPE_PROXYTYPE:
      return "SPHERE";
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return "MULTI_SPHERE";
    case CAPSULE_SHAPE_PROXYTYPE:
      return "CAPSULE";
    case CONE_SHAPE_PROXYTYPE:
      return "CONE";
    case CONVEX_SHAPE_PROXYTYPE:
      return "CONVEX";
    case CYLINDER_SHAPE_PROXYTYPE:
      return "CYLINDER";
    case UNIFORM_SCALING_SHAPE_PROXYTYPE:
      return "UNIFORM_SCALING";
    case MINKOWSKI_SUM_SHAPE_PROXYTYPE:
      return "MINKOWSKI_SUM";
    case MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE:
      return "MINKOWSKI_DIFFERENCE";
    case CUSTOM_CONVEX_SHAPE_TYPE:
      return "CUSTOM_CONVEX";
    case STATIC_PLANE_PROXYTYPE:
      return "STATIC_PLANE";
    default:
      return nullptr;
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
