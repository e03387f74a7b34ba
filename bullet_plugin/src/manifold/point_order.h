// The order of a manifold's points: Options::order_points_by_impulse.
//
// Bullet's contact solver goes through the points one after the other, and leaves more undone of what comes later. The
// point that carried most in the last step comes first here, the others follow around the patch. Two opposite corners
// first would carry three quarters of the load and let stacks of small boxes rock (four of 0.2 m at 60 Hz: 23 mm away
// after 5 s, 7 with this order); a last point that carries much feeds the sway of high towers (scenes/tower_20.json in
// float: 83 mm/s with an order that does not depend on impulses, 0.6 with this; Bullet's narrowphase 42).
//
// On what cannot move, points keep their order. There an order that depends on impulses feeds back, and poles rock for
// ever (a box of 0.04 x 0.04 x 0.4 m at 60 Hz: 50 mm/s at its end, 0.1 without).
//
// Physics: points, forces and their sum are the same in a solver that converges. Links of multibodies, which another
// solver takes, keep their order: with this one, the gripper of tests/apps drops 41 of 126 boxes in double and 44 in
// float, 31 without (42 at 240, 480, 1000 Hz).
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <utility>

#include "body_velocity.h"
#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Ratio of impulses from which the first point changes: with nearly equal ones the order stays, since changing it from
/// step to step makes bodies at rest tremble. With 1.2, stacks of small boxes creep half as far again; with 2, a tower
/// of twenty sways by half as much again.
constexpr btScalar kClearlyMoreImpulse = btScalar(1.5);

inline void OrderByImpulse(btPersistentManifold& manifold) {
  const int count = manifold.getNumContacts();
  const btCollisionObject &body_0 = *manifold.getBody0(), &body_1 = *manifold.getBody1();
  if (count < 2 || AsLink(body_0) != nullptr || AsLink(body_1) != nullptr) return;
  if (body_0.isStaticOrKinematicObject() || body_1.isStaticOrKinematicObject()) return;
  DGD_ASSERT(count <= MANIFOLD_CACHE_SIZE);
  btManifoldPoint& first = manifold.getContactPoint(0);
  for (int i = 1; i < count; ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.m_appliedImpulse > kClearlyMoreImpulse * first.m_appliedImpulse) std::swap(point, first);
  }
  // An impact is shared best by opposite points first, which is a patch's own order.
  if (!(first.m_appliedImpulse > 0)) return;
  const auto is_before = [&first](const btManifoldPoint& point, const btManifoldPoint& other) {
    const btVector3 &origin = first.m_positionWorldOnB, &normal = first.m_normalWorldOnB;
    return (point.m_positionWorldOnB - origin).cross(other.m_positionWorldOnB - origin).dot(normal) > 0;
  };
  // Insertion is quick, since most often they are in order already.
  for (int i = 2; i < count; ++i) {
    for (int j = i; j > 1 && is_before(manifold.getContactPoint(j), manifold.getContactPoint(j - 1)); --j) {
      std::swap(manifold.getContactPoint(j), manifold.getContactPoint(j - 1));
    }
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
