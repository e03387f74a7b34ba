// Which pairs may be solved at the same time, by a Bullet that is built without BT_THREADSAFE.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

#include "dgd_bullet/linkage.h"

class btCollisionShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Makes algorithms that may run at the same time as others, and may be made then: what they share is safe, except what
/// they get from the dispatcher.
struct ConcurrentCreateFunc : btCollisionAlgorithmCreateFunc {};

/// Makes algorithms that may, if those that the dispatcher has for the types of all children may.
struct CompoundCreateFunc : btCollisionAlgorithmCreateFunc {};

/// A dispatcher's table.
using CreateFuncs = btCollisionAlgorithmCreateFunc* [MAX_BROADPHASE_COLLISION_TYPES][MAX_BROADPHASE_COLLISION_TYPES];

/// Whether what the table has for a pair of shapes makes such algorithms, for all children of a compound.
bool IsConcurrent(const CreateFuncs& create_funcs, const btCollisionShape& shape_0, const btCollisionShape& shape_1);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
