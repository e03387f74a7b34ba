// In which order a pair's shapes are solved: the same whichever of the two bodies Bullet names first, so that a pair's
// contacts are the same to the last bit but for the normal's sign.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

namespace dgd_bullet {

/// Whether body_1 comes before body_0: by their shapes' types, else along a direction of the world that no scene is
/// built along, so that bodies that lie still keep their order. Addresses would change from run to run.
inline bool ComesFirst(const btCollisionObjectWrapper& body_1, const btCollisionObjectWrapper& body_0) {
  const int type_0 = body_0.getCollisionShape()->getShapeType(), type_1 = body_1.getCollisionShape()->getShapeType();
  if (type_0 != type_1) return type_1 < type_0;
  const btVector3 &at_0 = body_0.getWorldTransform().getOrigin(), &at_1 = body_1.getWorldTransform().getOrigin();
  const btVector3 direction(btScalar(0.4834), btScalar(0.5742), btScalar(0.6607));
  return direction.dot(at_1) < direction.dot(at_0);
}

}  // namespace dgd_bullet
