#include "friction_anchors.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <cstddef>

namespace dgd_bullet {
namespace {

/// Of the breaking threshold: a body that slips by more has slid. By measurement (contact_report, float, no resting
/// contacts kept): with this scenes/pyramid_28.json creeps by 1.3 mm in a minute, with a tenth of it by 25 mm.
constexpr btScalar kMaxSlip = btScalar(0.01);

/// Contact flags are bits of an integer in Bullet.
constexpr int kAnchored = BT_CONTACT_FLAG_FRICTION_ANCHOR;
constexpr int kNotOurs = kAnchored | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;

/// On fewer points bodies rock, and would be given back what they slipped: fifty polytopes come to rest a tenth later.
constexpr int kFewestOfFace = 3;

bool Sticks(const btManifoldPoint& point) {
  const btScalar lateral_1 = point.m_appliedImpulseLateral1, lateral_2 = point.m_appliedImpulseLateral2;
  const btScalar cone = point.m_combinedFriction * point.m_appliedImpulse;
  return lateral_1 * lateral_1 + lateral_2 * lateral_2 < cone * cone;
}

}  // namespace

FrictionAnchors::FrictionAnchors(const btPersistentManifold& manifold) : size_(manifold.getNumContacts()) {
  for (int i = 0; i < size_; ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    anchors_[static_cast<std::size_t>(i)] = {point.m_localPointA, point.m_localPointB, point.getLifeTime(),
                                             Sticks(point)};
  }
}

void FrictionAnchors::Restore(btPersistentManifold& manifold) const {
  const btTransform& pose_a = manifold.getBody0()->getWorldTransform();
  const btTransform& pose_b = manifold.getBody1()->getWorldTransform();
  const btScalar max_slip = kMaxSlip * manifold.getContactBreakingThreshold();
  if (manifold.getNumContacts() < kFewestOfFace) return;
  for (int i = 0; i < size_ && i < manifold.getNumContacts(); ++i) {
    const Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
    btManifoldPoint& point = manifold.getContactPoint(i);
    // A continued point keeps its place and its life time; one that took the place of another has none yet.
    const bool is_continued = anchor.life_time > 0 && point.getLifeTime() == anchor.life_time;
    if (!is_continued || !anchor.sticks || (point.m_contactPointFlags & kNotOurs) != 0) continue;
    const btVector3& normal = point.m_normalWorldOnB;
    btVector3 slip = pose_a(anchor.on_a) - pose_b(anchor.on_b);
    slip -= slip.dot(normal) * normal;
    const btScalar length = slip.length();
    if (!(length < btScalar(SIMD_INFINITY))) continue;
    if (length > max_slip) slip *= max_slip / length;
    point.m_localPointA = pose_a.invXform(point.m_positionWorldOnA + btScalar(0.5) * slip);
    point.m_localPointB = pose_b.invXform(point.m_positionWorldOnB - btScalar(0.5) * slip);
    point.m_contactPointFlags |= kAnchored;
  }
}

void FrictionAnchors::HoldKept(btPersistentManifold& manifold) {
  if (manifold.getNumContacts() < kFewestOfFace) return;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if ((point.m_contactPointFlags & kNotOurs) == 0 && Sticks(point)) point.m_contactPointFlags |= kAnchored;
  }
}

}  // namespace dgd_bullet
