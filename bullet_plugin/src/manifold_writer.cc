#include "manifold_writer.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "asked_by_app.h"
#include "contact_materials.h"
#include "finite_result.h"
#include "friction_anchors.h"
#include "restitution.h"

namespace dgd_bullet {
namespace {

/// A patch in Bullet's numbers, and which of the manifold's points its own continue.
struct BulletPatch {
  struct Contact {
    btVector3 on_a, on_b;    // World, metres.
    btVector3 on_a_in_body;  // By FindContinued().
    btScalar separation;
    int continued;  // Index of a point in the manifold, or kNew.
  };

  static constexpr int kNew = -1;

  BulletPatch(const dgd::ContactPatch<double>& patch, const Vector3& normal)
      : normal_on_b(ToBullet(-normal)), size(patch.size) {
    for (int i = 0; i < size; ++i) {
      const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
      const btVector3 on_b = ToBullet(point.on_2);
      const auto separation = btScalar(point.separation);
      contacts[static_cast<std::size_t>(i)] = {on_b + normal_on_b * separation, on_b, {}, separation, kNew};
    }
  }

  bool IsSomewhere() const {
    return std::all_of(contacts.begin(), contacts.begin() + size, [](const Contact& contact) {
      return dgd_bullet::IsSomewhere(contact.on_b, contact.separation);
    });
  }

  /// No two contacts continue the same point.
  void FindContinued(const btPersistentManifold& manifold) {
    const int cached = manifold.getNumContacts();
    const btTransform& pose_a = manifold.getBody0()->getWorldTransform();
    const btScalar threshold = manifold.getContactBreakingThreshold();
    for (int i = 0; i < size; ++i) {
      Contact& contact = contacts[static_cast<std::size_t>(i)];
      contact.on_a_in_body = pose_a.invXform(contact.on_a);
      btScalar nearest_sq = threshold * threshold;
      int nearest = kNew;
      for (int j = 0; j < cached; ++j) {
        if (is_continued[static_cast<std::size_t>(j)]) continue;
        const btScalar distance_sq = (manifold.getContactPoint(j).m_localPointA - contact.on_a_in_body).length2();
        if (!(distance_sq < nearest_sq)) continue;
        nearest_sq = distance_sq;
        nearest = j;
      }
      contact.continued = nearest;
      if (nearest != kNew) is_continued[static_cast<std::size_t>(nearest)] = true;
    }
  }

  btVector3 normal_on_b;
  int size;
  std::array<Contact, dgd::ContactPatch<double>::kMaxPoints> contacts;
  std::array<bool, MANIFOLD_CACHE_SIZE> is_continued{};  // By the manifold's points.
};

void DropStalePoints(btPersistentManifold& manifold, BulletPatch& patch) {
  for (int j = manifold.getNumContacts() - 1; j >= 0; --j) {
    if (patch.is_continued[static_cast<std::size_t>(j)]) continue;
    // Bullet moves the last point into the gap.
    const int last = manifold.getNumContacts() - 1;
    manifold.removeContactPoint(j);
    for (int i = 0; i < patch.size; ++i) {
      BulletPatch::Contact& contact = patch.contacts[static_cast<std::size_t>(i)];
      if (contact.continued == last) contact.continued = j;
    }
  }
}

/// As btManifoldResult::addContactPoint() leaves points that it continues, and btPersistentManifold's refresh after it.
class ContactRenewal {
 public:
  /// @param time_step  Seconds; 0 for no anchors.
  ContactRenewal(const btVector3& normal_on_b, btScalar time_step, const btManifoldResult& output)
      : normal_on_b_(normal_on_b),
        wrapper_a_(*output.getBody0Wrap()),
        wrapper_b_(*output.getBody1Wrap()),
        pose_a_(wrapper_a_.getCollisionObject()->getWorldTransform()),
        pose_b_(wrapper_b_.getCollisionObject()->getWorldTransform()),
        anchors_(*output.getPersistentManifold(), time_step),
        materials_(*wrapper_a_.getCollisionObject(), *wrapper_b_.getCollisionObject()) {
    btPlaneSpace1(normal_on_b_, lateral_1_, lateral_2_);
    is_seen_by_app_ =
        gContactAddedCallback != nullptr && HasFlag(*wrapper_a_.getCollisionObject(), *wrapper_b_.getCollisionObject(),
                                                    btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }

  void Renew(const BulletPatch::Contact& contact, btManifoldPoint& point) const {
    const bool is_held = anchors_.CanHold(point);
    const btVector3 slip = is_held ? anchors_.SlipOf(point) : btVector3(0, 0, 0);
    point.m_localPointA = contact.on_a_in_body;
    point.m_localPointB = pose_b_.invXform(contact.on_b);
    point.m_positionWorldOnA = contact.on_a;
    point.m_positionWorldOnB = contact.on_b;
    point.m_normalWorldOnB = normal_on_b_;
    point.m_lateralFrictionDir1 = lateral_1_;
    point.m_lateralFrictionDir2 = lateral_2_;
    point.m_distance1 = contact.separation;
    // What only an app's callbacks set.
    point.m_contactPointFlags = 0;
    point.m_contactMotion1 = point.m_contactMotion2 = 0;
    point.m_contactCFM = point.m_contactERP = point.m_frictionCFM = 0;
    materials_.ApplyTo(point);
    if (is_seen_by_app_) {
      gContactAddedCallback(point, &wrapper_a_, point.m_partId0, point.m_index0, &wrapper_b_, point.m_partId1,
                            point.m_index1);
    }
    if (is_held) anchors_.Hold(point, slip);
  }

 private:
  const btVector3& normal_on_b_;
  const btCollisionObjectWrapper &wrapper_a_, &wrapper_b_;
  const btTransform &pose_a_, &pose_b_;  // Of the bodies, in whose frames the points are.
  const FrictionAnchors anchors_;
  const ContactMaterials materials_;
  bool is_seen_by_app_;
  btVector3 lateral_1_, lateral_2_;
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

void WriteInPlace(BulletPatch& patch, btScalar anchor_time_step, btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  patch.FindContinued(manifold);
  DropStalePoints(manifold, patch);
  const ContactRenewal renewal(patch.normal_on_b, patch.size >= kFewestAnchors ? anchor_time_step : 0, output);
  RaisedThreshold threshold(manifold);
  for (int i = 0; i < patch.size; ++i) {
    const BulletPatch::Contact& contact = patch.contacts[static_cast<std::size_t>(i)];
    if (contact.continued != BulletPatch::kNew) {
      renewal.Renew(contact, manifold.getContactPoint(contact.continued));
    } else {
      threshold.Admit(contact.separation);
      output.addContactPoint(patch.normal_on_b, contact.on_b, contact.separation);
    }
  }
  CountStep(manifold);
}

void WriteThroughBullet(const dgd::ContactPatch<double>& patch, const Vector3& normal, bool drop_stale,
                        btManifoldResult& output) {
  btPersistentManifold& manifold = *output.getPersistentManifold();
  BulletPatch contacts(patch, normal);
  if (drop_stale) {
    contacts.FindContinued(manifold);
    DropStalePoints(manifold, contacts);
  }
  RaisedThreshold threshold(manifold);
  for (int i = 0; i < contacts.size; ++i) threshold.Admit(contacts.contacts[static_cast<std::size_t>(i)].separation);
  WritePatch(patch, normal, output);
  output.refreshContactPoints();
  DropPointsNotFinite(manifold);
}

/// Points that were not there in the last step: a refresh counts their age.
int CountAdded(const btPersistentManifold& manifold) {
  int added = 0;
  for (int i = 0; i < manifold.getNumContacts(); ++i) added += manifold.getContactPoint(i).getLifeTime() == 0;
  return added;
}

int DeepestOf(const btPersistentManifold& manifold) {
  int deepest = 0;
  for (int i = 1; i < manifold.getNumContacts(); ++i) {
    if (manifold.getContactPoint(i).getDistance() < manifold.getContactPoint(deepest).getDistance()) deepest = i;
  }
  return deepest;
}

/// A measure of what four points span, whatever their order: twice the area of a quadrilateral, square metres.
btScalar Span(const std::array<btVector3, MANIFOLD_CACHE_SIZE>& points) {
  const auto& [a, b, c, d] = points;
  return std::max({(a - b).cross(c - d).length(), (a - c).cross(b - d).length(), (a - d).cross(b - c).length()});
}

/// Whether a point on body B, world, spans clearly more with three points of a full manifold than all four do. The
/// deepest stays, as in Bullet's own choice.
bool Widens(const btVector3& point_on_b, const btPersistentManifold& manifold) {
  // So a mesh's points do not take turns. By measurement, of a hundred boxes as in the test SharedManifold: with 1.05
  // in its place they lie less still by a third, and land no less deep.
  constexpr btScalar kClearly = btScalar(1.2);
  std::array<btVector3, MANIFOLD_CACHE_SIZE> points;
  for (int i = 0; i < MANIFOLD_CACHE_SIZE; ++i) {
    points[static_cast<std::size_t>(i)] = manifold.getContactPoint(i).m_positionWorldOnB;
  }
  const btScalar enough = kClearly * Span(points);
  const int deepest = DeepestOf(manifold);
  for (int i = 0; i < MANIFOLD_CACHE_SIZE; ++i) {
    if (i == deepest) continue;
    std::array<btVector3, MANIFOLD_CACHE_SIZE> others = points;
    others[static_cast<std::size_t>(i)] = point_on_b;
    if (Span(others) > enough) return true;
  }
  return false;
}

/// Whether the first point of a patch continues one of the manifold's.
bool Continues(const dgd::ContactPatch<double>& patch, const Vector3& normal, const btPersistentManifold& manifold) {
  BulletPatch contacts(patch, normal);
  contacts.FindContinued(manifold);
  return contacts.contacts[0].continued != BulletPatch::kNew;
}

/// An app's own result has its own way with contacts, and Bullet has with points that it anchors.
bool HasOwnWay(const btManifoldResult& output) {
  const btCollisionObject &body_0 = *output.getBody0Internal(), &body_1 = *output.getBody1Internal();
  return IsAskedByApp(output) || output.getPersistentManifold()->getBody0() != &body_0 ||
         HasFlag(body_0, body_1, btCollisionObject::CF_HAS_FRICTION_ANCHOR);
}

}  // namespace

void OrderByImpulse(btPersistentManifold& manifold) {
  // Of nearly equal ones the order is kept: changing it from step to step makes bodies at rest tremble.
  constexpr btScalar kMore = btScalar(1.2);
  // By insertion: there are four at most, most often in order already.
  for (int i = 1; i < manifold.getNumContacts(); ++i) {
    for (int j = i; j > 0; --j) {
      btManifoldPoint &before = manifold.getContactPoint(j - 1), &point = manifold.getContactPoint(j);
      if (!(point.m_appliedImpulse > kMore * before.m_appliedImpulse)) break;
      std::swap(before, point);
    }
  }
}

void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output) {
  if (!AreBodiesSomewhere(output)) return;
  const btVector3 normal_on_b = ToBullet(-normal);
  for (int i = 0; i < patch.size; ++i) {
    const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    const btVector3 on_b = ToBullet(point.on_2);
    const auto separation = btScalar(point.separation);
    if (IsSomewhere(on_b, separation)) output.addContactPoint(normal_on_b, on_b, separation);
  }
}

void UpdateManifold(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                    const ManifoldUpdate& update, btManifoldResult& output) {
  BulletPatch contacts(patch, normal);
  if (update.drop_stale && !HasOwnWay(output) && contacts.IsSomewhere() && AreBodiesSomewhere(output)) {
    WriteInPlace(contacts, update.hold_stuck ? btScalar(motion.TimeStep()) : 0, output);
  } else {
    WriteThroughBullet(patch, normal, update.drop_stale, output);
  }
  btPersistentManifold& manifold = *output.getPersistentManifold();
  for (int i = 0; i < manifold.getNumContacts(); ++i) PrepareRebound(manifold.getContactPoint(i), motion);
  OrderByImpulse(manifold);
}

void AddToShared(const dgd::ContactPatch<double>& patch, const Vector3& normal, double equal_depth,
                 btManifoldResult& output) {
  if (patch.size == 0) return;
  const btPersistentManifold& manifold = *output.getPersistentManifold();
  const int size = manifold.getNumContacts();
  if (size < MANIFOLD_CACHE_SIZE || CountAdded(manifold) == size || IsAskedByApp(output)) {
    WritePatch(patch, normal, output);
    return;
  }
  dgd::ContactPatch<double> deepest = patch;
  deepest.size = 1;
  const dgd::ContactPoint<double>& point = deepest.points[0];
  const auto of_manifold = double(manifold.getContactPoint(DeepestOf(manifold)).getDistance());
  if (point.separation + equal_depth < of_manifold || Continues(deepest, normal, manifold) ||
      Widens(ToBullet(point.on_2), manifold)) {
    WritePatch(deepest, normal, output);
  }
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

}  // namespace dgd_bullet
