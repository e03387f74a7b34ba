#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <typeinfo>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether the contacts go to the app itself, by a result that derives from Bullet's, and not into a step's manifolds.
inline bool IsUserQuery(const btManifoldResult& output) { return typeid(output) != typeid(btManifoldResult); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
