#include "shape_type_name.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <array>
#include <cstddef>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

constexpr auto kNames = [] {
  std::array<const char*, MAX_BROADPHASE_COLLISION_TYPES> names{};
  names[BOX_SHAPE_PROXYTYPE] = "BOX";
  names[TRIANGLE_SHAPE_PROXYTYPE] = "TRIANGLE";
  names[TETRAHEDRAL_SHAPE_PROXYTYPE] = "TETRAHEDRAL";
  names[CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE] = "CONVEX_TRIANGLEMESH";
  names[CONVEX_HULL_SHAPE_PROXYTYPE] = "CONVEX_HULL";
  names[CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE] = "CONVEX_POINT_CLOUD";
  names[CUSTOM_POLYHEDRAL_SHAPE_TYPE] = "CUSTOM_POLYHEDRAL";
  names[SPHERE_SHAPE_PROXYTYPE] = "SPHERE";
  names[MULTI_SPHERE_SHAPE_PROXYTYPE] = "MULTI_SPHERE";
  names[CAPSULE_SHAPE_PROXYTYPE] = "CAPSULE";
  names[CONE_SHAPE_PROXYTYPE] = "CONE";
  names[CONVEX_SHAPE_PROXYTYPE] = "CONVEX";
  names[CYLINDER_SHAPE_PROXYTYPE] = "CYLINDER";
  names[UNIFORM_SCALING_SHAPE_PROXYTYPE] = "UNIFORM_SCALING";
  names[MINKOWSKI_SUM_SHAPE_PROXYTYPE] = "MINKOWSKI_SUM";
  names[MINKOWSKI_DIFFERENCE_SHAPE_PROXYTYPE] = "MINKOWSKI_DIFFERENCE";
  names[CUSTOM_CONVEX_SHAPE_TYPE] = "CUSTOM_CONVEX";
  names[STATIC_PLANE_PROXYTYPE] = "STATIC_PLANE";
  return names;
}();

}  // namespace

const char* ShapeTypeName(int type) {
  const auto index = static_cast<std::size_t>(type);
  return index < kNames.size() ? kNames[index] : nullptr;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
