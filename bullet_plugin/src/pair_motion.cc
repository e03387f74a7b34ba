#include "pair_motion.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace dgd_bullet {
namespace {

/// Distance from the body's centre to the farthest corner of its bounding box: no point of the body is farther.
/// Bullet's own bound, getAngularMotionDisc(), computes a bounding box first.
double Reach(const btCollisionObject& object, const Vector3& center) {
  const btBroadphaseProxy* proxy = object.getBroadphaseHandle();
  if (proxy == nullptr) {
    return double(object.getCollisionShape()->getAngularMotionDisc());
  }
  const Vector3 low = FromBullet(proxy->m_aabbMin), high = FromBullet(proxy->m_aabbMax);
  return (high - center).cwiseMax(center - low).norm();
}

}  // namespace

PairMotion::Twist PairMotion::Read(const btCollisionObject& object, double& rim_speed) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr || body->isStaticObject()) return {};
  // The centre of mass is the origin of the world transform.
  const Twist twist{FromBullet(body->getLinearVelocity()), FromBullet(body->getAngularVelocity()),
                    FromBullet(body->getWorldTransform().getOrigin())};
  rim_speed += twist.angular.norm() * Reach(object, twist.center);
  return twist;
}

PairMotion::PairMotion(const btCollisionObject& body_a, const btCollisionObject& body_b, double time_step)
    : time_step_(time_step) {
  double rim_speed = 0;
  a_ = Read(body_a, rim_speed);
  b_ = Read(body_b, rim_speed);
  max_approach_ = time_step * ((b_.linear - a_.linear).norm() + rim_speed);
}

}  // namespace dgd_bullet
