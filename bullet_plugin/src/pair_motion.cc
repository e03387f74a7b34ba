#include "pair_motion.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btTransformUtil.h>

#include <cmath>
#include <limits>

#include "body_velocity.h"
#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

double BoundingRadius(const btCollisionObject& object, const btVector3& from) {
  const btBroadphaseProxy* proxy = object.getBroadphaseHandle();
  if (proxy == nullptr) {
    return double(object.getCollisionShape()->getAngularMotionDisc() +
                  (object.getWorldTransform().getOrigin() - from).length());
  }
  btVector3 farthest = proxy->m_aabbMax - from;
  farthest.setMax(from - proxy->m_aabbMin);
  return double(farthest.length());
}

BoundedBody::BoundedBody(const btCollisionObject& body)
    : object(body), radius(BoundingRadius(body, body.getWorldTransform().getOrigin())) {}

namespace {

/// Distance from a body's centre of mass to the farthest point that approaches anything as the body turns: a ball's
/// surface about a point of it does not.
double RimRadius(const BoundedBody& body) {
  const btCollisionShape& shape = *body.object.getCollisionShape();
  if (shape.getShapeType() == SPHERE_SHAPE_PROXYTYPE) return 0;
  if (shape.getShapeType() != CAPSULE_SHAPE_PROXYTYPE) return body.radius;
  return double(static_cast<const btCapsuleShape&>(shape).getHalfHeight());
}

}  // namespace

PairMotion::Twist PairMotion::Read(const BoundedBody& body, double time_step) {
  const btCollisionObject& object = body.object;
  // Apps that make a body kinematic as Bullet's manual says leave it flagged as static, too.
  if (object.isStaticObject() && !object.isKinematicObject()) return {};
  const btMultiBodyLinkCollider* link = AsLink(object);
  const auto twist_of = [&](const BodyVelocity& velocity, const btVector3& acceleration) {
    return Twist{FromBullet(velocity.linear),
                 FromBullet(velocity.angular),
                 FromBullet(btScalar(time_step) * acceleration),
                 FromBullet(object.getWorldTransform().getOrigin()),
                 &object,
                 body.radius,
                 RimRadius(body),
                 link != nullptr};
  };
  if (const btRigidBody* rigid = btRigidBody::upcast(&object)) {
    return twist_of(VelocityOf(object), rigid->getInvMass() * rigid->getTotalForce());
  }
  return link == nullptr ? Twist() : twist_of(VelocityOf(*link), AccelerationOf(*link));
}

dgd::Motion<double> PairMotion::Twist::MotionOf(const Pose& pose, double time) const {
  Vector3 turn = time * angular;
  const double angle = turn.norm(), most = double(ANGULAR_MOTION_THRESHOLD);
  // btTransformUtil::integrateTransform() bounds the half angle whose sine it takes, but not the axis that it turns by.
  if (angle > most && !is_link && !body->isKinematicObject()) {
    turn *= 2 * std::atan(std::tan(most / 2) / most * angle) / angle;
  }
  return {pose, time * linear, turn, pose.rotation.transpose() * (center - pose.translation)};
}

double PairMotion::Twist::GyrationSq(const Vector3& axis) const {
  const btRigidBody* rigid = body == nullptr ? nullptr : btRigidBody::upcast(body);
  if (rigid == nullptr || !(rigid->getInvMass() > 0)) return std::numeric_limits<double>::infinity();
  const btVector3 about = ToBullet(axis);
  return axis.squaredNorm() * double(rigid->getInvMass() / about.dot(rigid->getInvInertiaTensorWorld() * about));
}

bool PairMotion::Twist::TurnsOver(const Vector3& from, const Vector3& to, const Vector3& axis) const {
  const double along = axis.dot(from - center);
  return GyrationSq(axis) + (from - center).dot(to - center) > along * along / axis.squaredNorm();
}

double PairMotion::Twist::TippingSpeed(const Vector3& from, const Vector3& axis) const {
  const Vector3 arm = center - from;
  return axis.dot(arm.cross(gain)) / (GyrationSq(axis) + arm.cross(axis).squaredNorm() / axis.squaredNorm());
}

PairMotion::PairMotion(const BoundedBody& body_a, const BoundedBody& body_b, double time_step)
    : a_(Read(body_a, time_step)), b_(Read(body_b, time_step)), time_step_(time_step) {
  DGD_ASSERT(time_step > 0);
}

double PairMotion::Bend(const Vector3& point) const {
  const double turn_a = time_step_ * a_.angular.norm(), turn_b = time_step_ * b_.angular.norm();
  if (!(turn_a + turn_b > 0)) return 0;
  // An arc leaves its tangent by half the square of its angle, and its circle never.
  const auto bend = [](double turn, double radius) { return std::min(turn * turn / 2, 2 + turn) * radius; };
  const double radius_a = (point - a_.center).norm();
  const double way = time_step_ * RelativeVelocity().norm() + turn_a * radius_a;
  return bend(turn_a, radius_a) + bend(turn_b, (point - b_.center).norm() + way) + turn_b * way;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
