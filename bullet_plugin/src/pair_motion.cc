#include "pair_motion.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace dgd_bullet {

double Reach(const btCollisionObject& object, const btVector3& from) {
  const btBroadphaseProxy* proxy = object.getBroadphaseHandle();
  if (proxy == nullptr) {
    return double(object.getCollisionShape()->getAngularMotionDisc() +
                  (object.getWorldTransform().getOrigin() - from).length());
  }
  btVector3 farthest = proxy->m_aabbMax - from;
  farthest.setMax(from - proxy->m_aabbMin);
  return double(farthest.length());
}

BodyReach::BodyReach(const btCollisionObject& body)
    : object(body), reach(Reach(body, body.getWorldTransform().getOrigin())) {}

PairMotion::Twist PairMotion::Read(const BodyReach& body) {
  const btRigidBody* rigid = btRigidBody::upcast(&body.object);
  if (rigid == nullptr || rigid->isStaticObject()) return {};
  // The centre of mass is the origin of the world transform.
  return {FromBullet(rigid->getLinearVelocity()), FromBullet(rigid->getAngularVelocity()),
          FromBullet(rigid->getWorldTransform().getOrigin()), body.reach};
}

dgd::Motion<double> PairMotion::Twist::MotionOf(const Pose& pose, double time) const {
  return {pose, time * linear, time * angular, pose.rotation.transpose() * (center - pose.translation)};
}

PairMotion::PairMotion(const BodyReach& body_a, const BodyReach& body_b, double time_step)
    : a_(Read(body_a)), b_(Read(body_b)), time_step_(time_step) {}

}  // namespace dgd_bullet
