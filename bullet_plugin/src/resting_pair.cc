#include "resting_pair.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include <limits>

#include "contact_materials.h"
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

/// A bound on the way of the points of a body whose farthest one is at most `reach` from its origin.
btScalar Way(const btTransform& from, const btTransform& to, btScalar reach) {
  btScalar turn_sq = 0;
  for (int row = 0; row < 3; ++row) turn_sq += (to.getBasis()[row] - from.getBasis()[row]).length2();
  return (to.getOrigin() - from.getOrigin()).length() + reach * btSqrt(turn_sq);
}

}  // namespace

RestingPair::RestingPair(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                         const btPersistentManifold& manifold)
    : sides_{{SideOf(body_0), SideOf(body_1)}}, contacts_(manifold.getNumContacts()) {}

bool RestingPair::CanTell(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                          double distance) {
  return IsFarAboveRounding(distance, body_0) && IsFarAboveRounding(distance, body_1) && HasComparableShape(body_0) &&
         HasComparableShape(body_1) && HasPlainMaterial(*body_0.getCollisionObject()) &&
         HasPlainMaterial(*body_1.getCollisionObject());
}

bool RestingPair::IsAsItWas(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                            const btPersistentManifold& manifold, const Hull& hull_0, const Hull& hull_1) const {
  const auto distance = btScalar(RestingDistance(double(manifold.getContactBreakingThreshold())));
  return manifold.getNumContacts() == contacts_ && IsSame(sides_[0], body_0, hull_0, distance) &&
         IsSame(sides_[1], body_1, hull_1, distance) && HasPlainMaterial(*body_0.getCollisionObject()) &&
         HasPlainMaterial(*body_1.getCollisionObject());
}

RestingPair::Side RestingPair::SideOf(const btCollisionObjectWrapper& body) {
  const auto& shape = static_cast<const btConvexShape&>(*body.getCollisionShape());
  const int type = shape.getShapeType();
  return {&shape, type, UpAxis(shape), SizeOf(shape, type), shape.getMargin(), body.getWorldTransform()};
}

bool RestingPair::IsSame(const Side& then, const btCollisionObjectWrapper& body, const Hull& hull, btScalar distance) {
  const auto* shape = static_cast<const btConvexShape*>(body.getCollisionShape());
  if (shape != then.shape) return false;
  // False also where a pose is not finite.
  const btTransform& pose = body.getWorldTransform();
  const double reach = Reach(*body.getCollisionObject(), pose.getOrigin());
  if (!(Way(then.pose, pose, btScalar(reach)) <= distance)) return false;
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
