#include "report/contact_drawer.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btIDebugDraw.h>

#include <array>
#include <cstdio>
#include <utility>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

constexpr btScalar kNormalLength = btScalar(0.1);  // Length in metres.

const btVector3 kNormalColor(1, btScalar(0.6), 0);
const btVector3 kOutlineColor(0, btScalar(0.8), 1);

using Points = std::array<const btManifoldPoint*, MANIFOLD_CACHE_SIZE>;

/// The points of a manifold, around their middle.
Points Around(const btPersistentManifold& manifold) {
  const int count = manifold.getNumContacts();
  btVector3 x, y, middle(0, 0, 0);
  btPlaneSpace1(manifold.getContactPoint(0).m_normalWorldOnB, x, y);
  DGD_ASSERT(count >= 1 && count <= MANIFOLD_CACHE_SIZE);
  Points points{};
  for (int i = 0; i < count; ++i) {
    points[std::size_t(i)] = &manifold.getContactPoint(i);
    middle += manifold.getContactPoint(i).m_positionWorldOnB / btScalar(count);
  }
  const auto angle_of = [&](const btManifoldPoint* point) {
    const btVector3 arm = point->m_positionWorldOnB - middle;
    return btAtan2(arm.dot(y), arm.dot(x));
  };
  for (std::size_t i = 1; i < std::size_t(count); ++i) {
    for (std::size_t j = i; j > 0 && angle_of(points[j]) < angle_of(points[j - 1]); --j) {
      std::swap(points[j], points[j - 1]);
    }
  }
  return points;
}

void DrawPatch(const btPersistentManifold& manifold, btIDebugDraw& drawer) {
  const auto count = std::size_t(manifold.getNumContacts());
  const Points points = Around(manifold);
  for (std::size_t i = 0; i < count; ++i) {
    const btManifoldPoint &point = *points[i], &next = *points[(i + 1) % count];
    drawer.drawLine(point.m_positionWorldOnA, next.m_positionWorldOnA, kOutlineColor);
    drawer.drawLine(point.m_positionWorldOnB, next.m_positionWorldOnB, kOutlineColor);
    drawer.drawLine(point.m_positionWorldOnB, point.m_positionWorldOnB + kNormalLength * point.m_normalWorldOnB,
                    kNormalColor);
  }
}

void DrawSeparation(const btManifoldPoint& point, btIDebugDraw& drawer) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%+.3g mm", 1000 * double(point.getDistance()));
  drawer.draw3dText(point.m_positionWorldOnB, text.data());
}

}  // namespace

void DrawContacts(const btPersistentManifold& manifold, btIDebugDraw* drawer) {
  if (drawer == nullptr || manifold.getNumContacts() == 0) return;
  const int mode = drawer->getDebugMode();
  if ((mode & btIDebugDraw::DBG_DrawContactPoints) != 0) DrawPatch(manifold, *drawer);
  if ((mode & btIDebugDraw::DBG_DrawText) != 0) DrawSeparation(manifold.getContactPoint(0), *drawer);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
