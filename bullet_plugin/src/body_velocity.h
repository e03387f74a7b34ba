// The velocity of a collision object: of a rigid body, or of a multibody's link.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btVector3.h>

#include "dgd_bullet/linkage.h"

class btMultiBodyLinkCollider;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Velocities in the world frame, metres and radians per second.
struct BodyVelocity {
  btVector3 linear{0, 0, 0};  ///< Velocity of the pose's origin, which is the centre of mass.
  btVector3 angular{0, 0, 0};
};

/// The velocity of a link by its joints, those before it and the base; the frames from one to the next are those that
/// the last step has left. The link's collider must be where the multibody has it.
BodyVelocity VelocityOf(const btMultiBodyLinkCollider& link);

/// Acceleration of a multibody by all forces on it, if its base moves; none if it is still, since the joints carry the
/// links then. World, metres per second squared.
btVector3 AccelerationOf(const btMultiBodyLinkCollider& link);

/// The object as a multibody's link, or null.
const btMultiBodyLinkCollider* AsLink(const btCollisionObject& object);

/// The velocity of an object; at rest if it is neither a rigid body nor a link.
inline BodyVelocity VelocityOf(const btCollisionObject& object) {
  if (const btRigidBody* rigid = btRigidBody::upcast(&object)) {
    return {rigid->getLinearVelocity(), rigid->getAngularVelocity()};
  }
  const btMultiBodyLinkCollider* link = AsLink(object);
  return link == nullptr ? BodyVelocity() : VelocityOf(*link);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
