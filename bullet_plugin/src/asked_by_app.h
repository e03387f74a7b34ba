#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <typeinfo>

namespace dgd_bullet {

/// Whether contacts go to the app itself, and not into a step's manifolds: it derives from Bullet's result.
inline bool IsAskedByApp(const btManifoldResult& output) { return typeid(output) != typeid(btManifoldResult); }

}  // namespace dgd_bullet
