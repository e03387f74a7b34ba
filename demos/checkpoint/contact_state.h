// The state of Bullet's pair cache and of the contact manifolds: what friction, restitution and warm starting of the
// solver depend on, and the order in which the solver takes contacts.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include "checkpoint/state_archive.h"

namespace dgd_demos {

/// Pairs and manifolds, in their order, with all points.
///
/// Reading: makes the pairs, and one collision detection makes their algorithms and manifolds, which are then
/// overwritten.
/// @pre reading: all objects are active, in the poses of the last collision detection; the broadphase has their
///      proxies.
/// @throws std::runtime_error if that makes other manifolds than were written.
void SerializeContacts(StateArchive& archive, btCollisionWorld& world);

}  // namespace dgd_demos
