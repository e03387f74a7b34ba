#include "pair_motion.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace dgd_bullet {

double Reach(const btCollisionObject& object) {
  const btBroadphaseProxy* proxy = object.getBroadphaseHandle();
  if (proxy == nullptr) {
    return double(object.getCollisionShape()->getAngularMotionDisc());
  }
  const Vector3 low = FromBullet(proxy->m_aabbMin), high = FromBullet(proxy->m_aabbMax);
  const Vector3 center = FromBullet(object.getWorldTransform().getOrigin());
  return (high - center).cwiseMax(center - low).norm();
}

void PairMotion::Read(const btCollisionObject& object, Twist& twist) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr || body->isStaticObject()) return;
  twist.linear = FromBullet(body->getLinearVelocity());
  twist.angular = FromBullet(body->getAngularVelocity());
  // The centre of mass is the origin of the world transform.
  twist.center = FromBullet(body->getWorldTransform().getOrigin());
  rim_speed_ += twist.angular.norm() * Reach(object);
}

dgd::Motion<double> PairMotion::Twist::MotionOf(const Pose& pose, double time) const {
  return {pose, time * linear, time * angular, pose.rotation.transpose() * (center - pose.translation)};
}

PairMotion::PairMotion(const btCollisionObject& body_a, const btCollisionObject& body_b, double time_step)
    : time_step_(time_step) {
  Read(body_a, a_);
  Read(body_b, b_);
}

}  // namespace dgd_bullet
