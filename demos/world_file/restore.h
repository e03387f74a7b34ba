// State that Bullet's importer leaves out, though the file has it.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <type_traits>

namespace dgd_demos {

// Structures in this Bullet's precision, as its own serializer chooses them.
inline constexpr bool kInDouble = std::is_same_v<btScalar, double>;
using BodyData = std::conditional_t<kInDouble, btRigidBodyDoubleData, btRigidBodyFloatData>;
using ObjectData = std::conditional_t<kInDouble, btCollisionObjectDoubleData, btCollisionObjectFloatData>;
using MultibodyData = std::conditional_t<kInDouble, btMultiBodyDoubleData, btMultiBodyFloatData>;
using ColliderData = std::conditional_t<kInDouble, btMultiBodyLinkColliderDoubleData, btMultiBodyLinkColliderFloatData>;

/// Restores surface, flags, sleep, and the exact sizes of scaled boxes and cylinders, which the importer scales twice.
void RestoreObject(const ObjectData& data, btCollisionObject& object);
/// Restores the collision filter, with a new proxy in the broadphase; group and mask are 0 if the object was in no
/// world.
void RestoreFilter(const ObjectData& data, btCollisionObject& object, btCollisionWorld& world);
/// Restores velocities, inertia, damping, gravity and forces.
void RestoreBody(const BodyData& data, btRigidBody& body);
/// Restores the velocities of base and joints, and the joints' damping, friction and limits.
void RestoreMultibody(const MultibodyData& data, btMultiBody& multibody);

}  // namespace dgd_demos
