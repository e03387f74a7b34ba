// Rigid bodies for worlds of tests and benchmarks. Metres, kilograms.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace dgd_test {

inline btVector3 Vec(double x, double y, double z) { return {btScalar(x), btScalar(y), btScalar(z)}; }

/// At rest at `pose`.
/// @param mass  0 for a static body.
inline std::unique_ptr<btRigidBody> MakeRigidBody(btCollisionShape& shape, double mass, const btTransform& pose) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(btScalar(mass), inertia);
  btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, &shape, inertia);
  info.m_startWorldTransform = pose;
  return std::make_unique<btRigidBody>(info);
}

}  // namespace dgd_test
