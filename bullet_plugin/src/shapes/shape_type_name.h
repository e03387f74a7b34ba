// Bullet's types of convex shapes, and of what else they meet here, by name.
#pragma once

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// As Bullet names the type, without "_SHAPE_PROXYTYPE"; null for one that no pair of ours has.
const char* ShapeTypeName(int type);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
