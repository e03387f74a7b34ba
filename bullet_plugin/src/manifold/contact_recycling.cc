#include "manifold/contact_recycling.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "dgd/assert.h"
#include "dgd_bullet/options.h"
#include "lengths.h"
#include "manifold/contact_materials.h"
#include "manifold/finishing.h"
#include "manifold/friction_anchors.h"
#include "manifold/manifold_writer.h"
#include "pair_manifold.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// How much more the rim of a body counts that tilts than contacts that slide: what tilts may bring down a corner that
/// is no contact. Depths are off by up to 25 micrometres with 1, 4.3 with 1.5, 0.4 from 2 on (dispatcher_replay, in
/// float).
constexpr double kTiltWeight = 2;

bool HasPlainMaterial(const btCollisionObject& body) {
  constexpr int kSeenByUser = btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK |
                              btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING |
                              btCollisionObject::CF_HAS_FRICTION_ANCHOR;
  return (body.getCollisionFlags() & kSeenByUser) == 0;
}

/// Whether a distance is well above the roundoff of a body's pose, by which small bodies far from the origin tremble.
bool IsFarAboveRoundoff(double distance, const btCollisionObjectWrapper& body) {
  constexpr double kDigits = 8 * double(std::numeric_limits<btScalar>::epsilon());
  return distance >= kDigits * double(body.getWorldTransform().getOrigin().length());
}

/// The largest displacement of a unit vector's end from one rotation to another: their difference has that as a
/// singular value twice, and 0.
btScalar Turn(const btMatrix3x3& from, const btMatrix3x3& to) {
  btScalar twice_sq = 0;
  for (int row = 0; row < 3; ++row) twice_sq += (to[row] - from[row]).length2();
  return btSqrt(twice_sq / 2);
}

/// A bound on the displacement of the points of a body whose farthest one is at most `radius` from its origin.
btScalar MaxDisplacement(const btTransform& from, const btTransform& to, btScalar radius) {
  return (to.getOrigin() - from.getOrigin()).length() + radius * Turn(from.getBasis(), to.getBasis());
}

/// The place of a contact on a body, in the frame of its shape, which may be a compound's child.
btVector3 PointOn(const btCollisionObjectWrapper& body, const btManifoldPoint& contact,
                  const btPersistentManifold& manifold) {
  const btCollisionObject* object = body.getCollisionObject();
  const btVector3& in_object = manifold.getBody0() == object ? contact.m_localPointA : contact.m_localPointB;
  const btTransform &pose = body.getWorldTransform(), &object_pose = object->getWorldTransform();
  return &pose == &object_pose ? in_object : pose.invXform(object_pose * in_object);
}

/// How two surfaces part along them: by `rise` on a length of `run`, in the direction where they part most.
struct Slope {
  double rise = 0, run = 0;
};

/// The slope between the surfaces at some contacts: none at a corner; at an edge, that along it.
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

/// How far contacts on a reference face may drift; metres.
double MaxDrift(const btPersistentManifold& manifold) {
  const auto breaking_threshold = double(manifold.getContactBreakingThreshold());
  const double max_rise = kRisePart * breaking_threshold, max_drift = kDriftPart * breaking_threshold;
  const auto [rise, run] = SlopeUnder(manifold);
  DGD_ASSERT(!(rise < 0) && !(run < 0));
  return max_drift * rise <= max_rise * run ? max_drift : max_rise * run / rise;
}

/// Whether contacts will still be on their reference face at the end of the step.
bool StayOn(const ReferenceFace& face, const PairMotion& motion, const btPersistentManifold& manifold) {
  if (face.side == dgd::ReferenceSide::kNone) return false;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    if (!(motion.Slip(FromBullet(manifold.getContactPoint(i).m_positionWorldOnB)) <= face.max_drift)) return false;
  }
  return kTiltWeight * motion.Tilt(FromBullet(manifold.getContactPoint(0).m_normalWorldOnB)) <= face.max_drift;
}

double StillDistance(const btPersistentManifold& manifold) {
  return kStillPart * double(manifold.getContactBreakingThreshold());
}

/// Whether a change of the pair can be recognised: the shapes have numbers that can be compared, the poses are exact
/// enough for the distance, and no app colours the contacts in each step.
bool IsCacheable(const btCollisionObjectWrapper& body, double distance) {
  return IsFarAboveRoundoff(distance, body) && ShapeIdentity::IsComparable(*body.getCollisionShape()) &&
         HasPlainMaterial(*body.getCollisionObject());
}

}  // namespace

bool MayRecycle(const Options& options, const PairManifold& manifold) {
  return options.keep_resting_contacts && manifold.IsOwn() && options.contact_patch && options.warm_start;
}

int MinRecycledContacts(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b) {
  return IsPolytope(*body_a.getCollisionShape()) && IsPolytope(*body_b.getCollisionShape()) ? 1 : 3;
}

ReferenceFace ReferenceFaceOf(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                              dgd::ReferenceSide side, const btPersistentManifold& manifold) {
  const int contacts = manifold.getNumContacts();
  if (contacts < MinRecycledContacts(body_a, body_b)) return {};
  if (side != dgd::ReferenceSide::kNone) return {side, MaxDrift(manifold)};
  // The normal of edges alone may turn by more than either body does.
  constexpr int kMinOfTwoFaces = 3;
  if (contacts < kMinOfTwoFaces) return {};
  return {dgd::ReferenceSide::kSet1, MaxDrift(manifold)};
}

RecycledContacts::CachedSide::CachedSide(const btCollisionObjectWrapper& body)
    : shape(*body.getCollisionShape()),
      pose(body.getWorldTransform()),
      radius(btScalar(BoundingRadius(*body.getCollisionObject(), pose.getOrigin()))) {}

RecycledContacts::RecycledContacts(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                                   const btPersistentManifold& manifold, const ReferenceFace& face)
    : sides_{{CachedSide(body_a), CachedSide(body_b)}},
      pose_ab_(sides_[0].pose.inverseTimes(sides_[1].pose)),
      face_(face),
      contacts_(manifold.getNumContacts()) {
  DGD_ASSERT(contacts_ >= 1 && contacts_ <= MANIFOLD_CACHE_SIZE && !(face.max_drift < 0));
  if (face_.side == dgd::ReferenceSide::kNone) return;
  normal_ = manifold.getContactPoint(0).m_normalWorldOnB * FaceSide().pose.getBasis();
}

bool RecycledContacts::Cache(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                             const ReferenceFace& face, const PairMotion& motion, const btPersistentManifold& manifold,
                             std::unique_ptr<RecycledContacts>& recycled) {
  // What may roll must have its contacts where it is, however slow.
  if (manifold.getNumContacts() < MinRecycledContacts(body_a, body_b)) return false;
  const double still = StillDistance(manifold);
  if (!motion.IsWithin(still) && !StayOn(face, motion, manifold)) return false;
  const double distance = std::max(still, face.max_drift);
  if (!IsCacheable(body_a, distance) || !IsCacheable(body_b, distance)) return false;
  const RecycledContacts now(body_a, body_b, manifold, face);
  if (recycled != nullptr) {
    *recycled = now;
  } else {
    recycled.reset(new (std::nothrow) RecycledContacts(now));
  }
  return recycled != nullptr;
}

RecycledContacts::PoseChange RecycledContacts::Compare(const Side& a, const Side& b,
                                                       const btPersistentManifold& manifold) const {
  if (manifold.getNumContacts() != contacts_) return PoseChange::kChanged;
  const PoseChange change = ComparePoses(a.body, b.body, manifold);
  const bool is_comparable = change != PoseChange::kChanged && IsSameShape(0, a) && IsSameShape(1, b) &&
                             HasPlainMaterial(*a.body.getCollisionObject()) &&
                             HasPlainMaterial(*b.body.getCollisionObject());
  return is_comparable ? change : PoseChange::kChanged;
}

/// @return kChanged also where a pose is not finite.
RecycledContacts::PoseChange RecycledContacts::ComparePoses(const btCollisionObjectWrapper& body_a,
                                                            const btCollisionObjectWrapper& body_b,
                                                            const btPersistentManifold& manifold) const {
  const btTransform &pose_a = body_a.getWorldTransform(), &pose_b = body_b.getWorldTransform();
  const auto distance = btScalar(StillDistance(manifold));
  if (MaxDisplacement(sides_[0].pose, pose_a, sides_[0].radius) <= distance &&
      MaxDisplacement(sides_[1].pose, pose_b, sides_[1].radius) <= distance) {
    return PoseChange::kStill;
  }
  if (face_.side == dgd::ReferenceSide::kNone) return PoseChange::kChanged;
  // Body B's motion as body A sees it: a point x of B's goes by turn * x + shift.
  const btTransform pose_ab = pose_a.inverseTimes(pose_b);
  const btMatrix3x3 turn = pose_ab.getBasis() - pose_ab_.getBasis();
  const btVector3 shift = pose_ab.getOrigin() - pose_ab_.getOrigin();
  const btVector3 normal_on_b = face_.side == dgd::ReferenceSide::kSet1 ? normal_ * pose_ab_.getBasis() : normal_;
  const btScalar radius = std::min(sides_[0].radius, sides_[1].radius);
  btScalar drift_sq = btScalar(kTiltWeight * kTiltWeight) * radius * radius * (turn * normal_on_b).length2();
  for (int i = 0; i < contacts_; ++i) {
    const btVector3 contact = PointOn(body_b, manifold.getContactPoint(i), manifold);
    drift_sq = std::max((turn * contact + shift).length2(), drift_sq);  // NaN is kept by this order.
  }
  const auto max_drift = btScalar(face_.max_drift);
  return drift_sq <= max_drift * max_drift ? PoseChange::kMovedTogether : PoseChange::kChanged;
}

void RecycledContacts::TurnNormals(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                                   btPersistentManifold& manifold) {
  DGD_ASSERT(face_.side != dgd::ReferenceSide::kNone);
  sides_[0].pose = body_a.getWorldTransform();
  sides_[1].pose = body_b.getWorldTransform();
  DGD_ASSERT(manifold.getNumContacts() == contacts_);
  const btVector3 normal = FaceSide().pose.getBasis() * normal_;
  for (int i = 0; i < manifold.getNumContacts(); ++i) manifold.getContactPoint(i).m_normalWorldOnB = normal;
}

bool RecycledContacts::Update(const Side& a, const Side& b, const Options& options, btScalar time_step,
                              const PairMotion& motion, btPersistentManifold& manifold, btManifoldResult& output) {
  DGD_ASSERT(output.getPersistentManifold() == &manifold);
  const PoseChange change = Compare(a, b, manifold);
  if (change == PoseChange::kChanged) return false;
  const bool has_moved = change == PoseChange::kMovedTogether;
  if (has_moved) TurnNormals(a.body, b.body, manifold);
  const bool was_loaded = IsLoaded(manifold);
  const ContactMaterials materials(*output.getBody0Internal(), *output.getBody1Internal());
  for (int i = 0; i < manifold.getNumContacts(); ++i) materials.ApplyTo(manifold.getContactPoint(i));
  if (options.friction_anchors && time_step > 0 && manifold.getNumContacts() >= kMinAnchors) {
    const FrictionAnchors anchors(manifold, time_step);
    for (int i = 0; i < manifold.getNumContacts(); ++i) anchors.RefreshRecycled(manifold.getContactPoint(i));
    CountStep(manifold);
  } else {
    output.refreshContactPoints();
  }
  FinishContacts(was_loaded, motion, has_moved && options.order_points_by_impulse, manifold);
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
