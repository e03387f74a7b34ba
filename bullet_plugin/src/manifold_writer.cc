#include "manifold_writer.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <array>
#include <cmath>
#include <utility>

#include "finite_result.h"

namespace dgd_bullet {

void DropStalePoints(btPersistentManifold& manifold, const dgd::ContactPatch<double>& patch) {
  const int cached = manifold.getNumContacts();
  if (cached == 0) return;
  const btTransform& transform_a = manifold.getBody0()->getWorldTransform();
  const btScalar threshold = manifold.getContactBreakingThreshold();
  std::array<bool, MANIFOLD_CACHE_SIZE> continued{};
  for (int i = 0; i < patch.size; ++i) {
    const btVector3 on_a = transform_a.invXform(ToBullet(patch.points[static_cast<std::size_t>(i)].on_1));
    btScalar nearest_sq = threshold * threshold;
    int nearest = -1;
    for (int j = 0; j < cached; ++j) {
      const btScalar distance_sq = (manifold.getContactPoint(j).m_localPointA - on_a).length2();
      if (distance_sq < nearest_sq) {
        nearest_sq = distance_sq;
        nearest = j;
      }
    }
    if (nearest >= 0) continued[static_cast<std::size_t>(nearest)] = true;
  }
  // From the end, since removal moves the last point into the gap.
  for (int j = cached - 1; j >= 0; --j) {
    if (!continued[static_cast<std::size_t>(j)]) manifold.removeContactPoint(j);
  }
}

void DropPointsNotFinite(btPersistentManifold& manifold) {
  for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
    if (!std::isfinite(manifold.getContactPoint(i).getDistance())) manifold.removeContactPoint(i);
  }
}

void WritePatch(const dgd::ContactPatch<double>& patch, const Vector3& normal, btManifoldResult& output) {
  const btVector3 normal_on_b = ToBullet(-normal);
  for (int i = 0; i < patch.size; ++i) {
    const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    const btVector3 on_b = ToBullet(point.on_2);
    const auto separation = btScalar(point.separation);
    if (IsSomewhere(output, on_b, separation)) output.addContactPoint(normal_on_b, on_b, separation);
  }
}

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

}  // namespace dgd_bullet
