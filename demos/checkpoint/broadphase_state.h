// The state of Bullet's dynamic bounding volume trees. The order in which they find new pairs is the order of contacts
// in the solver, and depends on all that came before.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include "checkpoint/state_archive.h"

namespace dgd_demos {

/// Proxies, trees and counters; not the pairs, which are the pair cache's.
/// @param objects  of the world, each with its proxy.
void SerializeBroadphase(StateArchive& archive, btDbvtBroadphase& broadphase, const btCollisionObjectArray& objects);

}  // namespace dgd_demos
