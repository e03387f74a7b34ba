// What two bodies' materials make of their contacts: the same for all points of a pair.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

inline bool HasFlag(const btCollisionObject& body_0, const btCollisionObject& body_1, int flag) {
  return ((body_0.getCollisionFlags() | body_1.getCollisionFlags()) & flag) != 0;
}

class ContactMaterials {
 public:
  ContactMaterials(const btCollisionObject& body_0, const btCollisionObject& body_1)
      : friction_(gCalculateCombinedFrictionCallback(&body_0, &body_1)),
        restitution_(gCalculateCombinedRestitutionCallback(&body_0, &body_1)),
        rolling_(gCalculateCombinedRollingFrictionCallback(&body_0, &body_1)),
        spinning_(gCalculateCombinedSpinningFrictionCallback(&body_0, &body_1)),
        has_stiffness_(HasFlag(body_0, body_1, btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING)) {
    if (!has_stiffness_) return;
    damping_ = gCalculateCombinedContactDampingCallback(&body_0, &body_1);
    stiffness_ = gCalculateCombinedContactStiffnessCallback(&body_0, &body_1);
  }

  void ApplyTo(btManifoldPoint& point) const {
    point.m_combinedFriction = friction_;
    point.m_combinedRestitution = restitution_;
    point.m_combinedRollingFriction = rolling_;
    point.m_combinedSpinningFriction = spinning_;
    if (!has_stiffness_) return;
    point.m_combinedContactDamping1 = damping_;
    point.m_combinedContactStiffness1 = stiffness_;
    point.m_contactPointFlags |= BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING;
  }

 private:
  btScalar friction_, restitution_, rolling_, spinning_;
  bool has_stiffness_;
  btScalar damping_ = 0, stiffness_ = 0;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
