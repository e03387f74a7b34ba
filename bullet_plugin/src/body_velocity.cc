#include "body_velocity.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

// Functions that Bullet's headers do not define are not called, so that apps without multibodies need not link them.
constexpr int kBase = -1;         // Bullet's index of the base.
constexpr int kBaseVelocity = 6;  // Numbers ahead of the joints' in Bullet's vector of velocities.

}  // namespace

const btMultiBodyLinkCollider* AsLink(const btCollisionObject& object) {
  const btMultiBodyLinkCollider* link = btMultiBodyLinkCollider::upcast(&object);
  return link == nullptr || link->m_multiBody == nullptr ? nullptr : link;
}

BodyVelocity VelocityOf(const btMultiBodyLinkCollider& link) {
  const btMultiBody& body = *link.m_multiBody;
  const btScalar* joint_velocities = body.getVelocityVector() + kBaseVelocity;
  const btVector3& place = link.getWorldTransform().getOrigin();
  BodyVelocity velocity;
  // A joint turns and moves all that comes after it, about the centre of mass of its own link.
  btTransform frame = link.getWorldTransform();
  for (int i = link.m_link; i != kBase; i = body.getLink(i).m_parent) {
    DGD_ASSERT(i >= 0 && i < body.getNumLinks());
    const btMultibodyLink& joint = body.getLink(i);
    for (int dof = 0; dof < joint.m_dofCount; ++dof) {
      const btScalar speed = joint_velocities[joint.m_dofOffset + dof];
      const btVector3 turning = speed * (frame.getBasis() * joint.getAxisTop(dof));
      velocity.angular += turning;
      velocity.linear +=
          speed * (frame.getBasis() * joint.getAxisBottom(dof)) + turning.cross(place - frame.getOrigin());
    }
    frame.getOrigin() -= frame.getBasis() * joint.m_cachedRVector;
    frame.getBasis() *= btMatrix3x3(joint.m_cachedRotParentToThis);
  }
  velocity.angular += body.getBaseOmega();
  velocity.linear += body.getBaseVel() + body.getBaseOmega().cross(place - frame.getOrigin());
  return velocity;
}

btVector3 AccelerationOf(const btMultiBodyLinkCollider& link) {
  const btMultiBody& body = *link.m_multiBody;
  // The joints carry what is fixed. Whether a base is fixed is not in Bullet's headers: it has no velocity then.
  if (body.getBaseVel().isZero() && body.getBaseOmega().isZero()) return {0, 0, 0};
  btVector3 force = body.getBaseForce();
  btScalar mass = body.getBaseMass();
  for (int i = 0; i < body.getNumLinks(); ++i) {
    force += body.getLink(i).m_appliedForce;
    mass += body.getLink(i).m_mass;
  }
  return mass > 0 ? force / mass : btVector3(0, 0, 0);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
