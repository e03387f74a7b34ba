#include "swept_box.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "bullet_conversions.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

Box SweptBox(const btCollisionObjectWrapper& shape, const btTransform& frame, const PairMotion& motion,
             double distance) {
  Box box;
  shape.getCollisionShape()->getAabb(frame.inverseTimes(shape.getWorldTransform()), box.low, box.high);
  const btVector3 middle = btScalar(0.5) * (box.low + box.high), half = btScalar(0.5) * (box.high - box.low);
  const btScalar radius = half.length();
  const auto turn = btScalar(motion.Turn().norm());
  const Vector3 middle_in_world = FromBullet(frame * middle);
  const auto out = btScalar(distance + motion.Bend(middle_in_world));
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 direction = FromBullet(frame.getBasis().getColumn(axis));
    const auto way = btScalar(motion.Approach(middle_in_world, direction));
    // Turning about its middle, the shape never leaves a ball.
    const btScalar turned = out + btMin(turn * radius, radius - half[axis]);
    box.low[axis] += btMin(way, btScalar(0)) - turned;
    box.high[axis] += btMax(way, btScalar(0)) + turned;
  }
  return box;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
