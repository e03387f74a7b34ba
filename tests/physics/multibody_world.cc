#include "physics/multibody_world.h"

namespace dgd_physics {

MultibodyWorld::MultibodyWorld(const Conditions& conditions)
    : dt_(1 / conditions.rate),
      dispatching_(conditions.narrowphase == Narrowphase::kOurs ? dgd_test::Route::kConfiguration
                                                                : dgd_test::Route::kBuiltin),
      world_(&dispatching_.dispatcher(), &broadphase_, &solver_, &dispatching_.configuration()) {
  world_.setGravity(Vec(0, 0, -kGravity));
}

MultibodyWorld::~MultibodyWorld() {
  for (const auto& body : bodies_) world_.removeMultiBody(body.get());
  for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
  for (const auto& body : statics_) world_.removeRigidBody(body.get());
}

btMultiBody& MultibodyWorld::AddBase(btCollisionShape& shape, double mass, const btTransform& pose, Surface surface) {
  btVector3 inertia;
  shape.calculateLocalInertia(btScalar(mass), inertia);
  btMultiBody& body = *bodies_.emplace_back(
      std::make_unique<btMultiBody>(0, btScalar(mass), inertia, /*fixedBase=*/false, /*canSleep=*/false));
  body.setBaseWorldTransform(pose);
  body.setLinearDamping(0);
  body.setAngularDamping(0);
  body.finalizeMultiDof();
  btMultiBodyLinkCollider& collider = *colliders_.emplace_back(std::make_unique<btMultiBodyLinkCollider>(&body, -1));
  collider.setCollisionShape(&shape);
  collider.setWorldTransform(pose);
  collider.setFriction(btScalar(surface.friction));
  collider.setRestitution(btScalar(surface.restitution));
  body.setBaseCollider(&collider);
  world_.addCollisionObject(&collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  world_.addMultiBody(&body);
  return body;
}

btRigidBody& MultibodyWorld::AddStatic(btCollisionShape& shape, const btTransform& pose, Surface surface) {
  btRigidBody& body = *statics_.emplace_back(dgd_test::MakeRigidBody(shape, 0, pose));
  body.setFriction(btScalar(surface.friction));
  body.setRestitution(btScalar(surface.restitution));
  world_.addRigidBody(&body);
  return body;
}

}  // namespace dgd_physics
