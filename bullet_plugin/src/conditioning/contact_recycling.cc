#include "conditioning/contact_recycling.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "conditioning/friction_anchors.h"
#include "conditioning/just_touching.h"
#include "pipeline/contact_materials.h"
#include "pipeline/manifold_writer.h"
#include "pipeline/pair_motion.h"
#include "shapes/multi_sphere.h"
#include "shapes/shape_adapter.h"
#include "shapes/shape_points.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// How much more the rim of a body counts that tilts than contacts that slide: what tilts may bring down a corner that
/// is no contact. By measurement, depths are off by up to 25 micrometres with 1, 4.3 with 1.5, 0.4 from 2 on
/// (dispatcher_replay, in float).
constexpr double kTiltWeight = 2;

/// The numbers that make a shape what it is, besides its margin; of hulls of points, the hull knows.
btVector3 SizeOf(const btCollisionShape& shape, int type) {
  switch (type) {
    case STATIC_PLANE_PROXYTYPE:
      return static_cast<const btStaticPlaneShape&>(shape).getPlaneNormal();
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

/// How far the surface is from what the size says.
btScalar OffsetOf(const btCollisionShape& shape, int type) {
  switch (type) {
    case STATIC_PLANE_PROXYTYPE:  // Its margin is not looked at.
      return static_cast<const btStaticPlaneShape&>(shape).getPlaneConstant();
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return btScalar(SmallestRadius(static_cast<const btMultiSphereShape&>(shape)));
    default:
      return shape.getMargin();
  }
}

int AxisOf(const btCollisionShape& shape, int type) {
  return type == STATIC_PLANE_PROXYTYPE ? kZAxis : UpAxis(static_cast<const btConvexShape&>(shape));
}

bool HasComparableShape(const btCollisionObjectWrapper& body) {
  switch (body.getCollisionShape()->getShapeType()) {
    case CONE_SHAPE_PROXYTYPE:
    case SPHERE_SHAPE_PROXYTYPE:
    case BOX_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
    case STATIC_PLANE_PROXYTYPE:
      return true;
    default:
      return IsHullOfPoints(static_cast<const btConvexShape&>(*body.getCollisionShape()));
  }
}

/// Whether a body does not roll: a polytope with a margin, or a half-space.
bool IsPolytope(const btCollisionObjectWrapper& body) {
  switch (body.getCollisionShape()->getShapeType()) {
    case BOX_SHAPE_PROXYTYPE:
    case STATIC_PLANE_PROXYTYPE:
      return true;
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return false;
    default:
      return IsHullOfPoints(static_cast<const btConvexShape&>(*body.getCollisionShape()));
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

/// How far apart two rotations bring a unit vector's end, at most: their difference has that as a singular value twice,
/// and 0.
btScalar Turn(const btMatrix3x3& from, const btMatrix3x3& to) {
  btScalar twice_sq = 0;
  for (int row = 0; row < 3; ++row) twice_sq += (to[row] - from[row]).length2();
  return btSqrt(twice_sq / 2);
}

/// A bound on the way of the points of a body whose farthest one is at most `reach` from its origin.
btScalar Way(const btTransform& from, const btTransform& to, btScalar reach) {
  return (to.getOrigin() - from.getOrigin()).length() + reach * Turn(from.getBasis(), to.getBasis());
}

/// Where a contact is on a body, in the frame of its shape, which may be a compound's child.
btVector3 PointOn(const btCollisionObjectWrapper& body, const btManifoldPoint& contact,
                  const btPersistentManifold& manifold) {
  const btCollisionObject* object = body.getCollisionObject();
  const btVector3& in_object = manifold.getBody0() == object ? contact.m_localPointA : contact.m_localPointB;
  const btTransform &pose = body.getWorldTransform(), &object_pose = object->getWorldTransform();
  return &pose == &object_pose ? in_object : pose.invXform(object_pose * in_object);
}

/// How much two surfaces part on a way between them: `rise` on one of `run`, where they part most.
struct Slope {
  double rise = 0, run = 0;
};

/// Of the surfaces under some contacts: a corner's is none, an edge's is that along it.
Slope SlopeUnder(const btPersistentManifold& manifold) {
  const int contacts = manifold.getNumContacts();
  if (contacts < 2) return {};
  // A point's own distance may be that of one shown as touching.
  const auto gap_of = [](const btManifoldPoint& point) {
    return (point.m_positionWorldOnA - point.m_positionWorldOnB).dot(point.m_normalWorldOnB);
  };
  const btManifoldPoint &first = manifold.getContactPoint(0), &second = manifold.getContactPoint(1);
  const btVector3 to_second = second.m_positionWorldOnB - first.m_positionWorldOnB;
  const btScalar rise_2 = gap_of(second) - gap_of(first);
  if (contacts == 2) return {std::abs(double(rise_2)), double(to_second.length())};
  const btManifoldPoint& third = manifold.getContactPoint(2);
  const btVector3 to_third = third.m_positionWorldOnB - first.m_positionWorldOnB;
  const btScalar rise_3 = gap_of(third) - gap_of(first);
  return {double((rise_2 * to_third - rise_3 * to_second).length()), double(to_second.cross(to_third).length())};
}

}  // namespace

int FewestOfFooting(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b) {
  return IsPolytope(body_a) && IsPolytope(body_b) ? 1 : 3;
}

Footing FootingOn(dgd::FaceHolder holder, const btPersistentManifold& manifold) {
  // Of the breaking threshold. By measurement, in float: with an eighth of the drift a heap's narrowphase takes 10 %
  // more, and it comes to rest 1.7 s later, for whatever is found anew has changed a little (big_scenes --scenes
  // boxes); without the limit on the rise, depths are off by up to 58 micrometres in place of 0.4 (dispatcher_replay).
  constexpr double kDrift = 8e-2, kRise = 5e-4;
  const auto breaking_threshold = double(manifold.getContactBreakingThreshold());
  const double most_rise = kRise * breaking_threshold, most_drift = kDrift * breaking_threshold;
  const auto [rise, run] = SlopeUnder(manifold);
  return {holder, most_drift * rise <= most_rise * run ? most_drift : most_rise * run / rise};
}

bool Lasts(const Footing& footing, const PairMotion& motion, const btPersistentManifold& manifold) {
  if (footing.holder == dgd::FaceHolder::kNone) return false;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    if (!(motion.Slip(FromBullet(manifold.getContactPoint(i).m_positionWorldOnB)) <= footing.max_drift)) return false;
  }
  return kTiltWeight * motion.Tilt(FromBullet(manifold.getContactPoint(0).m_normalWorldOnB)) <= footing.max_drift;
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
  const Since places = ComparePlaces(body_a, body_b, manifold);
  const bool is_comparable = places != Since::kChanged && IsSameShape(sides_[0], body_a, hull_a) &&
                             IsSameShape(sides_[1], body_b, hull_b) && HasPlainMaterial(*body_a.getCollisionObject()) &&
                             HasPlainMaterial(*body_b.getCollisionObject());
  return is_comparable ? places : Since::kChanged;
}

/// Changed also where a pose is not finite.
RestingPair::Since RestingPair::ComparePlaces(const btCollisionObjectWrapper& body_a,
                                              const btCollisionObjectWrapper& body_b,
                                              const btPersistentManifold& manifold) const {
  const btTransform &pose_a = body_a.getWorldTransform(), &pose_b = body_b.getWorldTransform();
  const auto distance = btScalar(RestingDistance(double(manifold.getContactBreakingThreshold())));
  if (Way(sides_[0].pose, pose_a, sides_[0].reach) <= distance &&
      Way(sides_[1].pose, pose_b, sides_[1].reach) <= distance) {
    return Since::kStill;
  }
  if (footing_.holder == dgd::FaceHolder::kNone) return Since::kChanged;
  // Body B's motion as body A sees it: a point x of B's goes by turn * x + shift.
  const btTransform between = pose_a.inverseTimes(pose_b);
  const btMatrix3x3 turn = between.getBasis() - between_.getBasis();
  const btVector3 shift = between.getOrigin() - between_.getOrigin();
  const btVector3 normal_on_b =
      footing_.holder == dgd::FaceHolder::kSet1 ? held_normal_ * between_.getBasis() : held_normal_;
  const btScalar reach = std::min(sides_[0].reach, sides_[1].reach);
  btScalar drift_sq = btScalar(kTiltWeight * kTiltWeight) * reach * reach * (turn * normal_on_b).length2();
  for (int i = 0; i < contacts_; ++i) {
    const btVector3 contact = PointOn(body_b, manifold.getContactPoint(i), manifold);
    drift_sq = std::max((turn * contact + shift).length2(), drift_sq);  // In this order no NaN is lost.
  }
  const auto max_drift = btScalar(footing_.max_drift);
  return drift_sq <= max_drift * max_drift ? Since::kMovedTogether : Since::kChanged;
}

void RestingPair::Follow(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                         btPersistentManifold& manifold) {
  sides_[0].pose = body_a.getWorldTransform();
  sides_[1].pose = body_b.getWorldTransform();
  const btVector3 normal = sides_[footing_.holder == dgd::FaceHolder::kSet1 ? 0 : 1].pose.getBasis() * held_normal_;
  for (int i = 0; i < manifold.getNumContacts(); ++i) manifold.getContactPoint(i).m_normalWorldOnB = normal;
  OrderForSolver(manifold);
}

RestingPair::Side RestingPair::SideOf(const btCollisionObjectWrapper& body) {
  const btCollisionShape& shape = *body.getCollisionShape();
  const int type = shape.getShapeType();
  const btTransform& pose = body.getWorldTransform();
  const auto reach = btScalar(Reach(*body.getCollisionObject(), pose.getOrigin()));
  return {&shape, type, AxisOf(shape, type), SizeOf(shape, type), OffsetOf(shape, type), reach, pose};
}

bool RestingPair::IsSameShape(const Side& then, const btCollisionObjectWrapper& body, const Hull& hull) {
  const btCollisionShape* shape = body.getCollisionShape();
  if (shape != then.shape) return false;
  const int type = shape->getShapeType();
  if (type != then.type || OffsetOf(*shape, type) != then.offset) return false;
  if (type != STATIC_PLANE_PROXYTYPE) {
    const auto& convex = static_cast<const btConvexShape&>(*shape);
    if (IsHullOfPoints(convex)) return hull != nullptr && hull->Matches(convex);
  }
  return AxisOf(*shape, type) == then.axis && SizeOf(*shape, type) == then.size;
}

bool RememberRest(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                  const Footing& footing, const PairMotion& motion, const btPersistentManifold& manifold,
                  std::unique_ptr<RestingPair>& resting) {
  // What may roll must have its contacts where it is, however slow.
  if (manifold.getNumContacts() < FewestOfFooting(body_a, body_b)) return false;
  const auto breaking_threshold = double(manifold.getContactBreakingThreshold());
  if (!motion.IsWithin(RestingDistance(breaking_threshold)) && !Lasts(footing, motion, manifold)) return false;
  if (!RestingPair::CanTell(body_a, body_b, breaking_threshold, footing)) return false;
  const RestingPair now(body_a, body_b, manifold, footing);
  if (resting != nullptr) {
    *resting = now;
  } else {
    resting.reset(new (std::nothrow) RestingPair(now));
  }
  return resting != nullptr;
}

bool KeepContacts(RestingPair& resting, const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                  const RestingPair::Hull& hull_a, const RestingPair::Hull& hull_b, double anchor_time_step,
                  btPersistentManifold& manifold, btManifoldResult& output) {
  const RestingPair::Since since = resting.Compare(body_a, body_b, manifold, hull_a, hull_b);
  if (since == RestingPair::Since::kChanged) return false;
  if (since == RestingPair::Since::kMovedTogether) resting.Follow(body_a, body_b, manifold);
  const bool was_loaded = IsLoaded(manifold);
  const ContactMaterials materials(*output.getBody0Internal(), *output.getBody1Internal());
  for (int i = 0; i < manifold.getNumContacts(); ++i) materials.ApplyTo(manifold.getContactPoint(i));
  if (anchor_time_step > 0 && manifold.getNumContacts() >= kFewestAnchors) {
    const FrictionAnchors anchors(manifold, btScalar(anchor_time_step));
    for (int i = 0; i < manifold.getNumContacts(); ++i) anchors.RefreshKept(manifold.getContactPoint(i));
    CountStep(manifold);
  } else {
    output.refreshContactPoints();
  }
  ShowTouching(manifold, was_loaded, {});
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
