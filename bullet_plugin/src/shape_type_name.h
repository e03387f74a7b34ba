// Bullet's types of convex shapes, and of what else they meet here, by name.
#pragma once

namespace dgd_bullet {

/// As Bullet names the type, without "_SHAPE_PROXYTYPE"; null for one that no pair of ours has.
const char* ShapeTypeName(int type);

}  // namespace dgd_bullet
