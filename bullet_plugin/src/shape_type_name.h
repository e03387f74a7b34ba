// Names of Bullet's types of convex shapes, and of planes.
#pragma once

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Bullet's name of a type, without "_SHAPE_PROXYTYPE"; null for a type that no pair here has.
const char* ShapeTypeName(int type);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
