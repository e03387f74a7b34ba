// The state of a world of Bullet's between two steps, exactly: a world that is made again from the same source and then
// reads it goes on as the first one does. To the bit, if its narrowphase depends on nothing but shapes, poses and
// manifolds: so do Bullet's own and, without Options::warm_start, that of this project.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "checkpoint/state_archive.h"

namespace dgd_demos {

/// Poses of all objects, in the order of the world's array.
std::vector<btTransform> PosesOf(const btCollisionWorld& world);

/// Bodies, multibodies, constraints, broadphase and contacts. The world's broadphase is a btDbvtBroadphase.
/// @param collision_poses  those at which the last collision detection ran: PosesOf() before the step.
/// @throws std::runtime_error reading: if the world is another one.
void SerializeWorld(StateArchive& archive, btDynamicsWorld& world, std::vector<btTransform> collision_poses);

}  // namespace dgd_demos
