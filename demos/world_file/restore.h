// What Bullet's importer leaves out, though the file has it.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <type_traits>

namespace dgd_demos {

// In this Bullet's precision, as its own serializer chooses them.
inline constexpr bool kInDouble = std::is_same_v<btScalar, double>;
using BodyData = std::conditional_t<kInDouble, btRigidBodyDoubleData, btRigidBodyFloatData>;
using ObjectData = std::conditional_t<kInDouble, btCollisionObjectDoubleData, btCollisionObjectFloatData>;
using MultibodyData = std::conditional_t<kInDouble, btMultiBodyDoubleData, btMultiBodyFloatData>;
using ColliderData = std::conditional_t<kInDouble, btMultiBodyLinkColliderDoubleData, btMultiBodyLinkColliderFloatData>;

/// Surface, flags, sleep, and the exact sizes of scaled boxes and cylinders, which the importer scales twice.
void RestoreObject(const ObjectData& data, btCollisionObject& object);
/// Its filter, with a new proxy in the broadphase; 0 and 0 where it was in no world.
void RestoreFilter(const ObjectData& data, btCollisionObject& object, btCollisionWorld& world);
/// Velocities, inertia, damping, gravity, forces.
void RestoreBody(const BodyData& data, btRigidBody& body);
/// Velocities of base and joints, and the joints' damping, friction and limits.
void RestoreMultibody(const MultibodyData& data, btMultiBody& multibody);

}  // namespace dgd_demos
