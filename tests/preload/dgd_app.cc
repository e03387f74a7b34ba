// An app that uses dgd_bullet itself: a box on a ground, for one step. Exit status 0 if they are in contact.
#include <btBulletDynamicsCommon.h>
#include <dgd_bullet/collision_configuration.h>

int main() {
  dgd_bullet::CollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btBoxShape shape(btVector3(1, 1, 1));
  btCollisionObject ground, box;
  for (btCollisionObject* object : {&ground, &box}) {
    object->setCollisionShape(&shape);
    world.addCollisionObject(object);
  }
  box.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(1.99))));
  world.performDiscreteCollisionDetection();
  const bool touches =
      dispatcher.getNumManifolds() == 1 && dispatcher.getManifoldByIndexInternal(0)->getNumContacts() > 0;
  world.removeCollisionObject(&box);
  world.removeCollisionObject(&ground);
  return touches ? 0 : 1;
}
