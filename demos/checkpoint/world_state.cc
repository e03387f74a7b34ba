#include "checkpoint/world_state.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <type_traits>

#include "checkpoint/broadphase_state.h"
#include "checkpoint/contact_state.h"

namespace dgd_demos {
namespace {

constexpr int kLastActivationState = 6;  // FIXED_BASE_MULTI_BODY, which not every Bullet has.

template <class Value, class Set>
void SerializeValue(StateArchive& archive, Value value, const Set& set) {
  if constexpr (std::is_arithmetic_v<Value>) {
    archive.Serialize(value);
  } else {
    archive.SerializePlain(value);
  }
  if (archive.is_reading()) set(value);
}

void SerializeObject(StateArchive& archive, btCollisionObject& object) {
  btRigidBody* const body = btRigidBody::upcast(&object);
  if (body != nullptr) {
    SerializeValue(archive, body->getLinearVelocity(), [&](const btVector3& v) { body->setLinearVelocity(v); });
    SerializeValue(archive, body->getAngularVelocity(), [&](const btVector3& w) { body->setAngularVelocity(w); });
  }
  SerializeValue(archive, object.getWorldTransform(), [&](const btTransform& pose) {
    body != nullptr ? body->setCenterOfMassTransform(pose) : object.setWorldTransform(pose);
  });
  SerializeValue(archive, object.getInterpolationWorldTransform(),
                 [&](const btTransform& pose) { object.setInterpolationWorldTransform(pose); });
  SerializeValue(archive, object.getInterpolationLinearVelocity(),
                 [&](const btVector3& v) { object.setInterpolationLinearVelocity(v); });
  SerializeValue(archive, object.getInterpolationAngularVelocity(),
                 [&](const btVector3& w) { object.setInterpolationAngularVelocity(w); });
  SerializeValue(archive, object.getHitFraction(), [&](btScalar fraction) { object.setHitFraction(fraction); });
  SerializeValue(archive, object.getDeactivationTime(), [&](btScalar time) { object.setDeactivationTime(time); });
  SerializeValue(archive, object.getActivationState(), [&](int state) {
    archive.Require(ACTIVE_TAG <= state && state <= kLastActivationState, "a body's activation state is out of range");
    object.forceActivationState(state);
  });
}

void SerializeLink(StateArchive& archive, btMultiBody& multibody, int number) {
  const btMultibodyLink& link = multibody.getLink(number);
  for (int i = 0; i < link.m_posVarCount; ++i) archive.Serialize(multibody.getJointPosMultiDof(number)[i]);
  for (int i = 0; i < link.m_dofCount; ++i) archive.Serialize(multibody.getJointVelMultiDof(number)[i]);
  // Has Bullet compute the link's cached frame.
  if (archive.is_reading()) multibody.setJointPosMultiDof(number, multibody.getJointPosMultiDof(number));
}

// Bullet's importer makes multibodies that never sleep.
void SerializeMultibody(StateArchive& archive, btMultiBody& multibody) {
  SerializeValue(archive, multibody.getBasePos(), [&](const btVector3& position) { multibody.setBasePos(position); });
  SerializeValue(archive, multibody.getWorldToBaseRot(),
                 [&](const btQuaternion& q) { multibody.setWorldToBaseRot(q); });
  SerializeValue(archive, multibody.getBaseVel(), [&](const btVector3& v) { multibody.setBaseVel(v); });
  SerializeValue(archive, multibody.getBaseOmega(), [&](const btVector3& w) { multibody.setBaseOmega(w); });
  for (int i = 0; i < multibody.getNumLinks(); ++i) SerializeLink(archive, multibody, i);
  if (archive.is_reading()) {
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    multibody.forwardKinematics(turns, places);
  }
}

void SerializeConstraint(StateArchive& archive, btTypedConstraint& constraint) {
  SerializeValue(archive, constraint.isEnabled(), [&](bool is_enabled) { constraint.setEnabled(is_enabled); });
  SerializeValue(archive, constraint.getAppliedImpulse(),
                 [&](btScalar impulse) { constraint.internalSetAppliedImpulse(impulse); });
}

void SerializeCollisionPoses(StateArchive& archive, btCollisionWorld& world, std::vector<btTransform>& poses) {
  archive.Serialize(poses, [&](btTransform& pose) { archive.SerializePlain(pose); });
  archive.Require(poses.size() == static_cast<std::size_t>(world.getNumCollisionObjects()),
                  "it has not one pose for each body");
  if (!archive.is_reading()) return;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
    btCollisionObject& object = *world.getCollisionObjectArray()[i];
    object.setWorldTransform(poses[static_cast<std::size_t>(i)]);
    object.forceActivationState(ACTIVE_TAG);
  }
}

}  // namespace

std::vector<btTransform> PosesOf(const btCollisionWorld& world) {
  std::vector<btTransform> poses;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
    poses.push_back(world.getCollisionObjectArray()[i]->getWorldTransform());
  }
  return poses;
}

void SerializeWorld(StateArchive& archive, btDynamicsWorld& world, std::vector<btTransform> collision_poses) {
  btCollisionObjectArray& objects = world.getCollisionObjectArray();
  archive.Expect(static_cast<std::uint64_t>(objects.size()), "bodies");
  archive.Expect(static_cast<std::uint64_t>(world.getNumConstraints()), "constraints");

  SerializeCollisionPoses(archive, world, collision_poses);
  SerializeBroadphase(archive, static_cast<btDbvtBroadphase&>(*world.getBroadphase()), objects);
  SerializeContacts(archive, world);

  if (auto* multibody_world = dynamic_cast<btMultiBodyDynamicsWorld*>(&world)) {
    for (int i = 0; i < multibody_world->getNumMultibodies(); ++i) {
      SerializeMultibody(archive, *multibody_world->getMultiBody(i));
    }
  }
  for (int i = 0; i < objects.size(); ++i) SerializeObject(archive, *objects[i]);
  for (int i = 0; i < world.getNumConstraints(); ++i) SerializeConstraint(archive, *world.getConstraint(i));

  auto& solver = static_cast<btSequentialImpulseConstraintSolver&>(*world.getConstraintSolver());
  SerializeValue(archive, solver.getRandSeed(), [&](unsigned long seed) { solver.setRandSeed(seed); });
}

}  // namespace dgd_demos
