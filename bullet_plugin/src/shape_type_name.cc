#include "shape_type_name.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <algorithm>
#include <array>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

struct TypeName {
  int type;
  const char* name;
};

constexpr std::array kTypeNames{TypeName{BOX_SHAPE_PROXYTYPE, "BOX"},
                                TypeName{TRIANGLE_SHAPE_PROXYTYPE, "TRIANGLE"},
                                TypeName{TETRAHEDRAL_SHAPE_PROXYTYPE, "TETRAHEDRAL"},
                                TypeName{CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE, "CONVEX_TRIANGLEMESH"},
                                TypeName{CONVEX_HULL_SHAPE_PROXYTYPE, "CONVEX_HULL"},
                                TypeName{CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE, "CONVEX_POINT_CLOUD"},
                                TypeName{CUSTOM_POLYHEDRAL_SHAPE_TYPE, "CUSTOM_POLYHEDRAL"},
                                TypeName{SPHERE_SHAPE_PROXYTYPE, "SPHERE"},
                                TypeName{MULTI_SPHERE_SHAPE_PROXYTYPE, "MULTI_SPHERE"},
                                TypeName{CAPSULE_SHAPE_PROXYTYPE, "CAPSULE"},
                                TypeName{CONE_SHAPE_PROXYTYPE, "CONE"},
                                TypeName{CONVEX_SHAPE_PROXYTYPE, "CONVEX"},
                                TypeName{CYLINDER_SHAPE_PROXYTYPE, "CYLINDER"},
                                TypeName{UNIFORM_SCALING_SHAPE_PROXYTYPE, "UNIFORM_SCALING"},
                                TypeName{MINKOWSKI_SUM_SHAPE_PROXYTYPE, "MINKOWSKI_SUM"},
                                TypeName{MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE, "MINKOWSKI_DIFFERENCE"},
                                TypeName{CUSTOM_CONVEX_SHAPE_TYPE, "CUSTOM_CONVEX"},
                                TypeName{STATIC_PLANE_PROXYTYPE, "STATIC_PLANE"}};

}  // namespace

const char* ShapeTypeName(int type) {
  const auto* found = std::ranges::find(kTypeNames, type, &TypeName::type);
  return found != kTypeNames.end() ? found->name : nullptr;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
