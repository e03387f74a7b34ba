#include "pair_motion.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace dgd_bullet {
namespace {

/// Velocities of one body; the centre of mass is the origin of its world transform.
struct BodyVelocity {
  explicit BodyVelocity(const btCollisionObjectWrapper& wrapper) {
    const btCollisionObject* object = wrapper.getCollisionObject();
    center = FromBullet(object->getWorldTransform().getOrigin());
    const btRigidBody* body = btRigidBody::upcast(object);
    if (body == nullptr || body->isStaticObject()) return;
    linear = FromBullet(body->getLinearVelocity());
    angular = FromBullet(body->getAngularVelocity());
    if (!(angular.squaredNorm() > 0)) return;
    // The shape may be a compound's child, whose frame is off the body's centre.
    const double lever = (FromBullet(wrapper.getWorldTransform().getOrigin()) - center).norm();
    rim_speed = angular.norm() * (lever + double(wrapper.getCollisionShape()->getAngularMotionDisc()));
  }

  Vector3 center;
  Vector3 linear = Vector3::Zero();
  Vector3 angular = Vector3::Zero();
  double rim_speed = 0;  // Of the farthest point, by rotation alone.
};

}  // namespace

PairMotion::PairMotion(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                       double time_step) {
  const BodyVelocity a(body_a), b(body_b);
  // Both motions seen from B's centre, where a point of A would move with linear + angular x offset.
  origin_ = b.center;
  displacement_ = time_step * (b.linear - a.linear - a.angular.cross(b.center - a.center));
  rotation_ = time_step * (b.angular - a.angular);
  max_approach_ = time_step * ((b.linear - a.linear).norm() + a.rim_speed + b.rim_speed);
}

}  // namespace dgd_bullet
