#include "checkpoint/world_state.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include "checkpoint/broadphase_state.h"
#include "checkpoint/contact_state.h"

namespace dgd_demos {
namespace {

template <class Value, class Set>
void AddValue(StateArchive& archive, Value value, const Set& set) {
  archive.AddPlain(value);
  if (archive.is_reading()) set(value);
}

void AddObject(StateArchive& archive, btCollisionObject& object) {
  btRigidBody* const body = btRigidBody::upcast(&object);
  if (body != nullptr) {
    AddValue(archive, body->getLinearVelocity(), [&](const btVector3& v) { body->setLinearVelocity(v); });
    AddValue(archive, body->getAngularVelocity(), [&](const btVector3& w) { body->setAngularVelocity(w); });
  }
  AddValue(archive, object.getWorldTransform(), [&](const btTransform& pose) {
    body != nullptr ? body->setCenterOfMassTransform(pose) : object.setWorldTransform(pose);
  });
  AddValue(archive, object.getInterpolationWorldTransform(),
           [&](const btTransform& pose) { object.setInterpolationWorldTransform(pose); });
  AddValue(archive, object.getInterpolationLinearVelocity(),
           [&](const btVector3& v) { object.setInterpolationLinearVelocity(v); });
  AddValue(archive, object.getInterpolationAngularVelocity(),
           [&](const btVector3& w) { object.setInterpolationAngularVelocity(w); });
  AddValue(archive, object.getHitFraction(), [&](btScalar fraction) { object.setHitFraction(fraction); });
  AddValue(archive, object.getDeactivationTime(), [&](btScalar time) { object.setDeactivationTime(time); });
  AddValue(archive, object.getActivationState(), [&](int state) { object.forceActivationState(state); });
}

void AddLink(StateArchive& archive, btMultiBody& multibody, int number) {
  const btMultibodyLink& link = multibody.getLink(number);
  for (int i = 0; i < link.m_posVarCount; ++i) archive.Add(multibody.getJointPosMultiDof(number)[i]);
  for (int i = 0; i < link.m_dofCount; ++i) archive.Add(multibody.getJointVelMultiDof(number)[i]);
  // Has Bullet compute the link's cached frame.
  if (archive.is_reading()) multibody.setJointPosMultiDof(number, multibody.getJointPosMultiDof(number));
}

// Bullet's importer makes multibodies that never sleep.
void AddMultibody(StateArchive& archive, btMultiBody& multibody) {
  AddValue(archive, multibody.getBasePos(), [&](const btVector3& position) { multibody.setBasePos(position); });
  AddValue(archive, multibody.getWorldToBaseRot(), [&](const btQuaternion& q) { multibody.setWorldToBaseRot(q); });
  AddValue(archive, multibody.getBaseVel(), [&](const btVector3& v) { multibody.setBaseVel(v); });
  AddValue(archive, multibody.getBaseOmega(), [&](const btVector3& w) { multibody.setBaseOmega(w); });
  for (int i = 0; i < multibody.getNumLinks(); ++i) AddLink(archive, multibody, i);
  if (archive.is_reading()) {
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    multibody.forwardKinematics(turns, places);
  }
}

void AddConstraint(StateArchive& archive, btTypedConstraint& constraint) {
  AddValue(archive, constraint.isEnabled(), [&](bool is_enabled) { constraint.setEnabled(is_enabled); });
  AddValue(archive, constraint.getAppliedImpulse(),
           [&](btScalar impulse) { constraint.internalSetAppliedImpulse(impulse); });
}

void AddCollisionPoses(StateArchive& archive, btCollisionWorld& world, std::vector<btTransform>& poses) {
  archive.Add(poses, [&](btTransform& pose) { archive.AddPlain(pose); });
  if (!archive.is_reading()) return;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
    btCollisionObject& object = *world.getCollisionObjectArray()[i];
    object.setWorldTransform(poses.at(static_cast<std::size_t>(i)));
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

void AddWorld(StateArchive& archive, btDynamicsWorld& world, std::vector<btTransform> collision_poses) {
  btCollisionObjectArray& objects = world.getCollisionObjectArray();
  archive.Expect(static_cast<std::uint64_t>(objects.size()), "bodies");
  archive.Expect(static_cast<std::uint64_t>(world.getNumConstraints()), "constraints");

  AddCollisionPoses(archive, world, collision_poses);
  AddBroadphase(archive, static_cast<btDbvtBroadphase&>(*world.getBroadphase()), objects);
  AddContacts(archive, world);

  if (auto* multibody_world = dynamic_cast<btMultiBodyDynamicsWorld*>(&world)) {
    for (int i = 0; i < multibody_world->getNumMultibodies(); ++i) {
      AddMultibody(archive, *multibody_world->getMultiBody(i));
    }
  }
  for (int i = 0; i < objects.size(); ++i) AddObject(archive, *objects[i]);
  for (int i = 0; i < world.getNumConstraints(); ++i) AddConstraint(archive, *world.getConstraint(i));

  auto& solver = static_cast<btSequentialImpulseConstraintSolver&>(*world.getConstraintSolver());
  AddValue(archive, solver.getRandSeed(), [&](unsigned long seed) { solver.setRandSeed(seed); });
}

}  // namespace dgd_demos
