#include "resting_pair.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include <algorithm>
#include <limits>

#include "contact_materials.h"
#include "manifold_writer.h"
#include "pair_motion.h"
#include "shape_adapter.h"
#include "shape_points.h"

namespace dgd_bullet {
namespace {

/// The numbers that make a shape what it is, besides its margin; of hulls of points, the hull knows.
btVector3 SizeOf(const btConvexShape& shape, int type) {
  switch (type) {
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      return {cone.getRadius(), cone.getHeight(), 0};
    }
    case SPHERE_SHAPE_PROXYTYPE:
    case BOX_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
      return static_cast<const btConvexInternalShape&>(shape).getImplicitShapeDimensions();
    default:
      return {0, 0, 0};
  }
}

bool HasComparableShape(const btCollisionObjectWrapper& body) {
  switch (const int type = body.getCollisionShape()->getShapeType()) {
    case CONE_SHAPE_PROXYTYPE:
    case SPHERE_SHAPE_PROXYTYPE:
    case BOX_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
      return true;
    default:
      return IsHullOfPoints(type);
  }
}

bool HasPlainMaterial(const btCollisionObject& body) {
  constexpr int kSeenByTheApp = btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK |
                                btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING |
                                btCollisionObject::CF_HAS_FRICTION_ANCHOR;
  return (body.getCollisionFlags() & kSeenByTheApp) == 0;
}

/// What poses are rounded to is no motion: small bodies far from the origin tremble by it.
bool IsFarAboveRounding(double distance, const btCollisionObjectWrapper& body) {
  constexpr double kDigits = 8 * double(std::numeric_limits<btScalar>::epsilon());
  return distance >= kDigits * double(body.getWorldTransform().getOrigin().length());
}

/// Of two rotations' difference: no unit vector's ends are farther apart.
btScalar Turn(const btMatrix3x3& from, const btMatrix3x3& to) {
  btScalar turn_sq = 0;
  for (int row = 0; row < 3; ++row) turn_sq += (to[row] - from[row]).length2();
  return btSqrt(turn_sq);
}

/// A bound on the way of the points of a body whose farthest one is at most `reach` from its origin.
btScalar Way(const btTransform& from, const btTransform& to, btScalar reach) {
  return (to.getOrigin() - from.getOrigin()).length() + reach * Turn(from.getBasis(), to.getBasis());
}

}  // namespace

Footing FootingOn(dgd::FaceHolder holder, const btPersistentManifold& manifold) {
  // Of the breaking threshold. By measurement: without the limit, depths are off by up to 25 micrometres in place of 4
  // (dispatcher_replay, with half the drift).
  constexpr double kRise = 5e-4;
  const auto breaking_threshold = double(manifold.getContactBreakingThreshold());
  const double most_rise = kRise * breaking_threshold, most_drift = MostDrift(breaking_threshold);
  const btManifoldPoint &first = manifold.getContactPoint(0), &second = manifold.getContactPoint(1),
                        &third = manifold.getContactPoint(2);
  const btVector3 to_second = second.m_positionWorldOnB - first.m_positionWorldOnB,
                  to_third = third.m_positionWorldOnB - first.m_positionWorldOnB;
  const btScalar rise_2 = second.getDistance() - first.getDistance(),
                 rise_3 = third.getDistance() - first.getDistance();
  // The surfaces part by rise / area of a way across the normal, where they part most.
  const auto rise = double((rise_2 * to_third - rise_3 * to_second).length());
  const auto area = double(to_second.cross(to_third).length());
  return {holder, most_drift * rise <= most_rise * area ? most_drift : most_rise * area / rise};
}

RestingPair::RestingPair(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                         const btPersistentManifold& manifold, const Footing& footing)
    : sides_{{SideOf(body_a), SideOf(body_b)}},
      between_(sides_[0].pose.inverseTimes(sides_[1].pose)),
      footing_(footing),
      contacts_(manifold.getNumContacts()) {
  if (footing_.holder == dgd::FaceHolder::kNone) return;
  const btMatrix3x3& rotation = sides_[footing_.holder == dgd::FaceHolder::kSet1 ? 0 : 1].pose.getBasis();
  held_normal_ = manifold.getContactPoint(0).m_normalWorldOnB * rotation;
}

bool RestingPair::CanTell(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                          double breaking_threshold, const Footing& footing) {
  const double distance = std::max(RestingDistance(breaking_threshold), footing.max_drift);
  return IsFarAboveRounding(distance, body_a) && IsFarAboveRounding(distance, body_b) && HasComparableShape(body_a) &&
         HasComparableShape(body_b) && HasPlainMaterial(*body_a.getCollisionObject()) &&
         HasPlainMaterial(*body_b.getCollisionObject());
}

RestingPair::Since RestingPair::Compare(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                                        const btPersistentManifold& manifold, const Hull& hull_a,
                                        const Hull& hull_b) const {
  if (manifold.getNumContacts() != contacts_) return Since::kChanged;
  const Since places = ComparePlaces(body_a, body_b, double(manifold.getContactBreakingThreshold()));
  const bool is_comparable = places != Since::kChanged && IsSameShape(sides_[0], body_a, hull_a) &&
                             IsSameShape(sides_[1], body_b, hull_b) && HasPlainMaterial(*body_a.getCollisionObject()) &&
                             HasPlainMaterial(*body_b.getCollisionObject());
  return is_comparable ? places : Since::kChanged;
}

/// Changed also where a pose is not finite.
RestingPair::Since RestingPair::ComparePlaces(const btCollisionObjectWrapper& body_a,
                                              const btCollisionObjectWrapper& body_b, double breaking_threshold) const {
  const btTransform &pose_a = body_a.getWorldTransform(), &pose_b = body_b.getWorldTransform();
  const auto reach_a = btScalar(Reach(*body_a.getCollisionObject(), pose_a.getOrigin()));
  const auto reach_b = btScalar(Reach(*body_b.getCollisionObject(), pose_b.getOrigin()));
  const auto distance = btScalar(RestingDistance(breaking_threshold));
  if (Way(sides_[0].pose, pose_a, reach_a) <= distance && Way(sides_[1].pose, pose_b, reach_b) <= distance) {
    return Since::kStill;
  }
  if (footing_.holder == dgd::FaceHolder::kNone) return Since::kChanged;
  // The points of either body, seen from the other, move by as much where the two meet.
  const btTransform between = pose_a.inverseTimes(pose_b);
  const btScalar turn = Turn(between_.getBasis(), between.getBasis());
  const btVector3 way = reach_a < reach_b
                            ? between_.getOrigin() * between_.getBasis() - between.getOrigin() * between.getBasis()
                            : between.getOrigin() - between_.getOrigin();
  const btScalar drift = way.length() + std::min(reach_a, reach_b) * turn;
  return drift <= btScalar(footing_.max_drift) ? Since::kMovedTogether : Since::kChanged;
}

void RestingPair::Follow(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                         btPersistentManifold& manifold) {
  sides_[0].pose = body_a.getWorldTransform();
  sides_[1].pose = body_b.getWorldTransform();
  const btVector3 normal = sides_[footing_.holder == dgd::FaceHolder::kSet1 ? 0 : 1].pose.getBasis() * held_normal_;
  for (int i = 0; i < manifold.getNumContacts(); ++i) manifold.getContactPoint(i).m_normalWorldOnB = normal;
  OrderByImpulse(manifold);
}

RestingPair::Side RestingPair::SideOf(const btCollisionObjectWrapper& body) {
  const auto& shape = static_cast<const btConvexShape&>(*body.getCollisionShape());
  const int type = shape.getShapeType();
  return {&shape, type, UpAxis(shape), SizeOf(shape, type), shape.getMargin(), body.getWorldTransform()};
}

bool RestingPair::IsSameShape(const Side& then, const btCollisionObjectWrapper& body, const Hull& hull) {
  const auto* shape = static_cast<const btConvexShape*>(body.getCollisionShape());
  if (shape != then.shape) return false;
  const int type = shape->getShapeType();
  if (type != then.type || shape->getMargin() != then.margin) return false;
  if (IsHullOfPoints(type)) return hull != nullptr && hull->Matches(*shape);
  return UpAxis(*shape) == then.axis && SizeOf(*shape, type) == then.size;
}

void KeepContacts(btPersistentManifold& manifold, btManifoldResult& output) {
  const ContactMaterials materials(*output.getBody0Internal(), *output.getBody1Internal());
  for (int i = 0; i < manifold.getNumContacts(); ++i) materials.ApplyTo(manifold.getContactPoint(i));
  output.refreshContactPoints();
}

}  // namespace dgd_bullet
