// A world of multibodies, which Bullet solves in coordinates of their own: robots, and all that PyBullet loads.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>
#include <vector>

#include "physics/lab.h"

namespace dgd_physics {

class MultibodyWorld {
 public:
  explicit MultibodyWorld(const Conditions& conditions);
  ~MultibodyWorld();
  MultibodyWorld(const MultibodyWorld&) = delete;
  MultibodyWorld& operator=(const MultibodyWorld&) = delete;

  /// A multibody of a base alone. The shape outlives the world.
  btMultiBody& AddBase(btCollisionShape& shape, double mass, const btTransform& pose, Surface surface);
  btRigidBody& AddStatic(btCollisionShape& shape, const btTransform& pose, Surface surface);
  void Step() { world_.stepSimulation(btScalar(dt_), 0); }

 private:
  double dt_;
  dgd_test::Dispatching dispatching_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  std::vector<std::unique_ptr<btRigidBody>> statics_;
  std::vector<std::unique_ptr<btMultiBody>> bodies_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
};

}  // namespace dgd_physics
