#include "pipeline/manifold_writer.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/finite_result.h"
#include "conditioning/friction_anchors.h"
#include "conditioning/restitution.h"
#include "dgd/assert.h"
#include "pipeline/body_velocity.h"
#include "pipeline/contact_materials.h"
#include "pipeline/mesh_triangle.h"
#include "pipeline/user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Contacts, and which of the manifold's points they continue.
class ContinuedContacts {
 public:
  static constexpr int kNew = -1;

  ContinuedContacts(std::span<const ManifoldContact> contacts, const btPersistentManifold& manifold)
      : size_(contacts.size()) {
    const int cached = manifold.getNumContacts();
    const btTransform& pose_a = manifold.getBody0()->getWorldTransform();
    const btScalar threshold = manifold.getContactBreakingThreshold();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      on_a_in_body_[i] = pose_a.invXform(contacts[i].OnA());
      btScalar nearest_sq = threshold * threshold;
      int nearest = kNew;
      for (int j = 0; j < cached; ++j) {
        if (IsContinued(j)) continue;
        const btScalar distance_sq = (manifold.getContactPoint(j).m_localPointA - on_a_in_body_[i]).length2();
        if (!(distance_sq < nearest_sq)) continue;
        nearest_sq = distance_sq;
        nearest = j;
      }
      continued_[i] = nearest;
      if (nearest != kNew) is_continued_[static_cast<std::size_t>(nearest)] = true;
    }
  }

  /// The manifold's point that a contact continues, or kNew. No two contacts continue the same one.
  int PointOf(std::size_t contact) const { return continued_[contact]; }
  bool IsContinued(int point) const { return is_continued_[static_cast<std::size_t>(point)]; }
  bool IsAnyContinued() const {
    return std::find(is_continued_.begin(), is_continued_.end(), true) != is_continued_.end();
  }
  /// Where a contact is on body A, in A's frame.
  const btVector3& OnAInBody(std::size_t contact) const { return on_a_in_body_[contact]; }

  /// Drops the manifold's points that no contact continues. If there are contacts and none continues, the first point
  /// is left for a new one to take its place: a contact that goes on at another point never passes through zero points.
  /// @return whether it is left.
  bool DropStale(btPersistentManifold& manifold) {
    const bool spares_first = size_ > 0 && manifold.getNumContacts() > 0 && !IsAnyContinued();
    for (int j = manifold.getNumContacts() - 1; j >= (spares_first ? 1 : 0); --j) {
      if (IsContinued(j)) continue;
      // Bullet moves the last point into the gap.
      const int last = manifold.getNumContacts() - 1;
      manifold.removeContactPoint(j);
      for (std::size_t i = 0; i < size_; ++i) {
        if (continued_[i] == last) continued_[i] = j;
      }
    }
    return spares_first;
  }

 private:
  std::size_t size_;
  std::array<btVector3, MANIFOLD_CACHE_SIZE> on_a_in_body_;
  std::array<int, MANIFOLD_CACHE_SIZE> continued_;
  std::array<bool, MANIFOLD_CACHE_SIZE> is_continued_{};  // By the manifold's points.
};

/// The names of parts and triangles that a result gives new points, for which Bullet has no other use.
class Identifiers : public btManifoldResult {
 public:
  /// @param is_swapped  Whether the manifold's first body is the result's second.
  static void Apply(const btManifoldResult& output, bool is_swapped, btManifoldPoint& point) {
    point.m_partId0 = output.*(is_swapped ? &Identifiers::m_partId1 : &Identifiers::m_partId0);
    point.m_partId1 = output.*(is_swapped ? &Identifiers::m_partId0 : &Identifiers::m_partId1);
    point.m_index0 = output.*(is_swapped ? &Identifiers::m_index1 : &Identifiers::m_index0);
    point.m_index1 = output.*(is_swapped ? &Identifiers::m_index0 : &Identifiers::m_index1);
  }
};

/// As btManifoldResult::addContactPoint() leaves points, new ones and those that it continues.
class PointWriter {
 public:
  /// @param anchor_time_step  Seconds, for friction anchors; 0 for none.
  PointWriter(btScalar anchor_time_step, btManifoldResult& output)
      : output_(output),
        manifold_(*output.getPersistentManifold()),
        is_swapped_(manifold_.getBody0() != output.getBody0Internal()),
        pose_a_(manifold_.getBody0()->getWorldTransform()),
        pose_b_(manifold_.getBody1()->getWorldTransform()),
        anchors_(manifold_, anchor_time_step),
        materials_(*WrapperA().getCollisionObject(), *WrapperB().getCollisionObject()),
        is_seen_by_app_(gContactAddedCallback != nullptr &&
                        HasFlag(*WrapperA().getCollisionObject(), *WrapperB().getCollisionObject(),
                                btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK)) {}

  void Renew(const ManifoldContact& contact, const btVector3& on_a_in_body, btManifoldPoint& point) {
    const bool is_held = anchors_.CanHold(point);
    const btVector3 slip = is_held ? anchors_.SlipOf(point) : btVector3(0, 0, 0);
    Fill(contact, on_a_in_body, point);
    // What only an app's callbacks set.
    point.m_contactPointFlags = 0;
    point.m_contactMotion1 = point.m_contactMotion2 = 0;
    point.m_contactCFM = point.m_contactERP = point.m_frictionCFM = 0;
    materials_.ApplyTo(point);
    Show(contact, point);
    if (is_held) anchors_.Hold(point, slip);
  }

  /// @param place  Of a stale point, or the number of points.
  void Add(const ManifoldContact& contact, const btVector3& on_a_in_body, int place) {
    btManifoldPoint point(on_a_in_body, {}, contact.normal_on_b, contact.separation);
    Fill(contact, on_a_in_body, point);
    Identifiers::Apply(output_, is_swapped_, point);
    materials_.ApplyTo(point);
    const bool is_first = manifold_.getNumContacts() == 0;
    if (place == manifold_.getNumContacts()) {
      // As Bullet's own: so the distance may be above the breaking threshold.
      constexpr bool kIsPredictive = true;
      manifold_.addManifoldPoint(point, kIsPredictive);
    } else {
      manifold_.clearUserCache(manifold_.getContactPoint(place));
      manifold_.getContactPoint(place) = point;
    }
    Show(contact, manifold_.getContactPoint(place));
    if (is_first && gContactStartedCallback != nullptr) gContactStartedCallback(&manifold_);
  }

 private:
  const btCollisionObjectWrapper& WrapperA() const {
    return is_swapped_ ? *output_.getBody1Wrap() : *output_.getBody0Wrap();
  }
  const btCollisionObjectWrapper& WrapperB() const {
    return is_swapped_ ? *output_.getBody0Wrap() : *output_.getBody1Wrap();
  }

  void Fill(const ManifoldContact& contact, const btVector3& on_a_in_body, btManifoldPoint& point) {
    // Most often all contacts of a manifold have one normal.
    if (!(contact.normal_on_b == normal_)) {
      normal_ = contact.normal_on_b;
      btPlaneSpace1(normal_, lateral_1_, lateral_2_);
    }
    point.m_localPointA = on_a_in_body;
    point.m_localPointB = pose_b_.invXform(contact.on_b);
    point.m_positionWorldOnA = contact.OnA();
    point.m_positionWorldOnB = contact.on_b;
    point.m_normalWorldOnB = normal_;
    point.m_lateralFrictionDir1 = lateral_1_;
    point.m_lateralFrictionDir2 = lateral_2_;
    point.m_distance1 = contact.separation;
  }

  /// Names the point's triangle, and has an app's callback see it.
  void Show(const ManifoldContact& contact, btManifoldPoint& point) const {
    if (contact.triangle == nullptr) {
      if (is_seen_by_app_) Call(WrapperA(), WrapperB(), point);
      return;
    }
    // A mesh is the second body in either order of the call.
    point.m_partId1 = contact.triangle->part;
    point.m_index1 = contact.triangle->index;
    if (!is_seen_by_app_) return;
    const TriangleBody triangle(*contact.triangle, WrapperB());
    Call(WrapperA(), triangle.wrapper(), point);
  }

  void Call(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, btManifoldPoint& point) const {
    const btScalar distance = point.m_distance1;
    gContactAddedCallback(point, &a, point.m_partId0, point.m_index0, &b, point.m_partId1, point.m_index1);
    // As by Bullet's refresh, which comes after the callbacks: the distance is that of the point's places.
    if (point.m_distance1 == distance) return;
    point.m_distance1 = (pose_a_(point.m_localPointA) - pose_b_(point.m_localPointB)).dot(point.m_normalWorldOnB);
  }

  btManifoldResult& output_;
  btPersistentManifold& manifold_;
  const bool is_swapped_;
  const btTransform &pose_a_, &pose_b_;  // Of the bodies, in whose frames the points are.
  const FrictionAnchors anchors_;
  const ContactMaterials materials_;
  const bool is_seen_by_app_;
  btVector3 normal_{0, 0, 0}, lateral_1_, lateral_2_;  // Of the last contact.
};

/// Bullet refuses points beyond the breaking threshold: speculative ones need it raised until they have passed.
class RaisedThreshold {
 public:
  explicit RaisedThreshold(btPersistentManifold& manifold)
      : manifold_(manifold), threshold_(manifold.getContactBreakingThreshold()) {}
  ~RaisedThreshold() { manifold_.setContactBreakingThreshold(threshold_); }
  RaisedThreshold(const RaisedThreshold&) = delete;
  RaisedThreshold& operator=(const RaisedThreshold&) = delete;

  void Admit(btScalar separation) {
    // Rounding to float must not put the point beyond its own threshold, nor its distance after a refresh.
    constexpr btScalar kSlack = btScalar(1.001);
    if (separation * kSlack > manifold_.getContactBreakingThreshold()) {
      manifold_.setContactBreakingThreshold(separation * kSlack);
    }
  }

 private:
  btPersistentManifold& manifold_;
  const btScalar threshold_;
};

void WriteInPlace(std::span<const ManifoldContact> contacts, btScalar anchor_time_step, btManifoldResult& output) {
  DGD_ASSERT(contacts.size() <= MANIFOLD_CACHE_SIZE);
  btPersistentManifold& manifold = *output.getPersistentManifold();
  ContinuedContacts continued(contacts, manifold);
  bool has_spare = continued.DropStale(manifold);
  PointWriter writer(contacts.size() >= std::size_t{kFewestAnchors} ? anchor_time_step : 0, output);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int point = continued.PointOf(i);
    if (point != ContinuedContacts::kNew) {
      writer.Renew(contacts[i], continued.OnAInBody(i), manifold.getContactPoint(point));
    } else {
      writer.Add(contacts[i], continued.OnAInBody(i), has_spare ? 0 : manifold.getNumContacts());
      has_spare = false;
    }
  }
  CountStep(manifold);
}

/// Adds contacts as Bullet does, which keeps the points that they continue.
void AddThroughBullet(std::span<const ManifoldContact> contacts, btManifoldResult& output) {
  if (!AreBodiesSomewhere(output)) return;
  const btCollisionObjectWrapper* mesh = output.getBody0Wrap();
  if (mesh->getCollisionObject() != output.getPersistentManifold()->getBody1()) mesh = output.getBody1Wrap();
  for (const ManifoldContact& contact : contacts) {
    if (!IsSomewhere(contact.on_b, contact.separation)) continue;
    if (contact.triangle == nullptr) {
      output.addContactPoint(contact.normal_on_b, contact.on_b, contact.separation);
    } else {
      const TriangleBody triangle(*contact.triangle, *mesh);
      const ShownTriangle shown(output, triangle.wrapper());
      output.addContactPoint(contact.normal_on_b, contact.on_b, contact.separation);
    }
  }
}

void WriteThroughBullet(std::span<const ManifoldContact> contacts, bool drop_stale, btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  std::optional<btVector3> spare;
  if (drop_stale && ContinuedContacts(contacts, manifold).DropStale(manifold)) {
    spare = manifold.getContactPoint(0).m_localPointA;
  }
  RaisedThreshold threshold(manifold);
  for (const ManifoldContact& contact : contacts) threshold.Admit(contact.separation);
  AddThroughBullet(contacts, output);
  const int last = manifold.getNumContacts() - 1;
  if (spare && last > 0 && manifold.getContactPoint(0).m_localPointA == *spare) {
    for (int i = 0; i < last; ++i) std::swap(manifold.getContactPoint(i), manifold.getContactPoint(i + 1));
    manifold.removeContactPoint(last);
  }
  output.refreshContactPoints();
  DropPointsNotFinite(manifold);
}

/// A patch in Bullet's numbers.
class BulletPatch {
 public:
  BulletPatch(const dgd::ContactPatch<double>& patch, const Vector3& normal)
      : size_(static_cast<std::size_t>(patch.size)) {
    const btVector3 normal_on_b = ToBullet(-normal);
    for (std::size_t i = 0; i < size_; ++i) {
      const dgd::ContactPoint<double>& point = patch.points[i];
      contacts_[i] = {normal_on_b, ToBullet(point.on_2), btScalar(point.separation)};
    }
  }

  std::span<const ManifoldContact> Contacts() const { return {contacts_.data(), size_}; }

 private:
  std::size_t size_;
  std::array<ManifoldContact, dgd::ContactPatch<double>::kMaxPoints> contacts_;
};

bool AreSomewhere(std::span<const ManifoldContact> contacts) {
  return std::all_of(contacts.begin(), contacts.end(),
                     [](const ManifoldContact& contact) { return IsSomewhere(contact.on_b, contact.separation); });
}

/// An app's own result has its own way with contacts, and Bullet has with points that it anchors.
bool HasOwnWay(const btManifoldResult& output) {
  return IsAskedByApp(output) ||
         HasFlag(*output.getBody0Internal(), *output.getBody1Internal(), btCollisionObject::CF_HAS_FRICTION_ANCHOR);
}

}  // namespace

void OrderForSolver(btPersistentManifold& manifold) {
  // Of nearly equal impulses the order is kept: changing it from step to step makes bodies at rest tremble. With 1.2,
  // stacks of small boxes creep half as far again; with 2, a tower of twenty sways by half as much again.
  constexpr btScalar kMore = btScalar(1.5);
  const int count = manifold.getNumContacts();
  if (count < 2 || AsLink(*manifold.getBody0()) != nullptr || AsLink(*manifold.getBody1()) != nullptr) return;
  btManifoldPoint& first = manifold.getContactPoint(0);
  for (int i = 1; i < count; ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.m_appliedImpulse > kMore * first.m_appliedImpulse) std::swap(point, first);
  }
  if (!(first.m_appliedImpulse > 0)) return;  // An impact is shared best by opposite points first, as a patch has them.
  const auto is_before = [&first](const btManifoldPoint& point, const btManifoldPoint& other) {
    const btVector3 &origin = first.m_positionWorldOnB, &normal = first.m_normalWorldOnB;
    return (point.m_positionWorldOnB - origin).cross(other.m_positionWorldOnB - origin).dot(normal) > 0;
  };
  // By insertion: most often they are in order already.
  for (int i = 2; i < count; ++i) {
    for (int j = i; j > 1 && is_before(manifold.getContactPoint(j), manifold.getContactPoint(j - 1)); --j) {
      std::swap(manifold.getContactPoint(j), manifold.getContactPoint(j - 1));
    }
  }
}

void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output) {
  AddThroughBullet(BulletPatch(patch, normal).Contacts(), output);
}

void UpdateManifold(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                    const ManifoldUpdate& update, btManifoldResult& output) {
  UpdateManifold(BulletPatch(patch, normal).Contacts(), motion, update, output);
}

void UpdateManifold(std::span<const ManifoldContact> contacts, const PairMotion& motion, const ManifoldUpdate& update,
                    btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  const bool was_loaded = IsLoaded(manifold);
  if (update.drop_stale && !HasOwnWay(output) && AreSomewhere(contacts) && AreBodiesSomewhere(output)) {
    WriteInPlace(contacts, update.hold_stuck ? btScalar(motion.TimeStep()) : 0, output);
  } else {
    WriteThroughBullet(contacts, update.drop_stale, output);
  }
  for (int i = 0; i < manifold.getNumContacts(); ++i) PrepareRebound(manifold.getContactPoint(i), motion);
  ShowTouching(manifold, was_loaded, motion);
  OrderForSolver(manifold);
}

void CountStep(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    ++point.m_lifeTime;
    if (gContactProcessedCallback == nullptr) continue;
    gContactProcessedCallback(point, const_cast<btCollisionObject*>(manifold.getBody0()),
                              const_cast<btCollisionObject*>(manifold.getBody1()));
  }
}

void DropPointsNotFinite(btPersistentManifold& manifold) {
  for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
    if (!std::isfinite(manifold.getContactPoint(i).getDistance())) manifold.removeContactPoint(i);
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
