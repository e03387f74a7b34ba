// In which order a pair's shapes are solved: the same whichever of the two bodies Bullet names first, so that a pair's
// contacts are the same to the last bit but for the normal's sign.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether `a` comes before `b`: by their shapes' types, in the one order that each pair of them is compiled in
/// (posed_shape.h), else along a direction of the world that no scene is built along, so that bodies that lie still
/// keep their order. Addresses would change from run to run.
inline bool ComesBefore(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
  const auto type_of = [](const btCollisionObjectWrapper& body) {
    const int type = body.getCollisionShape()->getShapeType();
    return type == MULTI_SPHERE_SHAPE_PROXYTYPE ? int(CONVEX_HULL_SHAPE_PROXYTYPE) : type;  // Of its spheres' centres.
  };
  const int type_a = type_of(a), type_b = type_of(b);
  if (type_a != type_b) return type_a < type_b;
  const btVector3 &at_a = a.getWorldTransform().getOrigin(), &at_b = b.getWorldTransform().getOrigin();
  const btVector3 direction(btScalar(0.4834), btScalar(0.5742), btScalar(0.6607));
  return direction.dot(at_a) < direction.dot(at_b);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
