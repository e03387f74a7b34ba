#include "conditioning/point_order.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <utility>

#include "pipeline/body_velocity.h"

namespace dgd_bullet::inline DGD_BULLET_PRECISION {
namespace {

/// Ratio of impulses from which the first point changes: with nearly equal ones the order stays, since changing it from
/// step to step makes bodies at rest tremble. With 1.2, stacks of small boxes creep half as far again; with 2, a tower
/// of twenty sways by half as much again.
constexpr btScalar kClearlyMore = btScalar(1.5);

}  // namespace

void OrderByImpulse(btPersistentManifold& manifold) {
  const int count = manifold.getNumContacts();
  if (count < 2 || AsLink(*manifold.getBody0()) != nullptr || AsLink(*manifold.getBody1()) != nullptr) return;
  btManifoldPoint& first = manifold.getContactPoint(0);
  for (int i = 1; i < count; ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.m_appliedImpulse > kClearlyMore * first.m_appliedImpulse) std::swap(point, first);
  }
  // An impact is shared best by opposite points first, which is a patch's own order.
  if (!(first.m_appliedImpulse > 0)) return;
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

}  // namespace dgd_bullet::inline DGD_BULLET_PRECISION
