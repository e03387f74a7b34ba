#include "pair_motion.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace dgd_bullet {

double Reach(const btCollisionObject& object, const Vector3& from) {
  const btBroadphaseProxy* proxy = object.getBroadphaseHandle();
  if (proxy == nullptr) {
    return double(object.getCollisionShape()->getAngularMotionDisc()) +
           (FromBullet(object.getWorldTransform().getOrigin()) - from).norm();
  }
  const Vector3 low = FromBullet(proxy->m_aabbMin), high = FromBullet(proxy->m_aabbMax);
  return (high - from).cwiseMax(from - low).norm();
}

PairMotion::Twist PairMotion::Read(const btCollisionObject& object) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  if (body == nullptr || body->isStaticObject()) return {};
  // The centre of mass is the origin of the world transform.
  const Vector3 center = FromBullet(body->getWorldTransform().getOrigin());
  return {FromBullet(body->getLinearVelocity()), FromBullet(body->getAngularVelocity()), center, Reach(object, center)};
}

dgd::Motion<double> PairMotion::Twist::MotionOf(const Pose& pose, double time) const {
  return {pose, time * linear, time * angular, pose.rotation.transpose() * (center - pose.translation)};
}

PairMotion::PairMotion(const btCollisionObject& body_a, const btCollisionObject& body_b, double time_step)
    : a_(Read(body_a)), b_(Read(body_b)), time_step_(time_step) {}

}  // namespace dgd_bullet
