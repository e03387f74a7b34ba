#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <typeinfo>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether contacts go to the app itself, and not into a step's manifolds: it derives from Bullet's result.
inline bool IsAskedByApp(const btManifoldResult& output) { return typeid(output) != typeid(btManifoldResult); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
