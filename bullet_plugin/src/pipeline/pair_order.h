// In which order a pair's shapes are solved: the same whichever of the two bodies Bullet names first, so that a pair's
// contacts are the same to the last bit but for the normal's sign.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether `a` comes before `b`: by their shapes' types, else along a direction of the world that no scene is built
/// along, so that bodies that lie still keep their order. Addresses would change from run to run.
inline bool ComesBefore(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
  const int type_a = a.getCollisionShape()->getShapeType(), type_b = b.getCollisionShape()->getShapeType();
  if (type_a != type_b) return type_a < type_b;
  const btVector3 &at_a = a.getWorldTransform().getOrigin(), &at_b = b.getWorldTransform().getOrigin();
  const btVector3 direction(btScalar(0.4834), btScalar(0.5742), btScalar(0.6607));
  return direction.dot(at_a) < direction.dot(at_b);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
