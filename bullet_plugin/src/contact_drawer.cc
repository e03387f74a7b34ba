#include "contact_drawer.h"

#include <LinearMath/btIDebugDraw.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "bullet_conversions.h"

namespace dgd_bullet {
namespace {

constexpr double kNormalLength = 0.1;  // Metres.

const btVector3 kNormalColor(1, btScalar(0.6), 0);
const btVector3 kOutlineColor(0, btScalar(0.8), 1);

/// The indices of the points, around their middle.
std::array<int, dgd::ContactPatch<double>::kMaxPoints> Around(const dgd::ContactPatch<double>& patch,
                                                              const Vector3& normal) {
  std::array<int, dgd::ContactPatch<double>::kMaxPoints> order{};
  std::array<double, dgd::ContactPatch<double>::kMaxPoints> angles{};
  const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
  Vector3 middle = Vector3::Zero();
  const auto count = static_cast<std::size_t>(patch.size);
  for (std::size_t i = 0; i < count; ++i) middle += patch.points[i].on_2 / double(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 arm = patch.points[i].on_2 - middle;
    order[i] = int(i);
    angles[i] = std::atan2(arm.dot(y), arm.dot(x));
  }
  std::sort(order.begin(), order.begin() + patch.size,
            [&](int i, int j) { return angles[std::size_t(i)] < angles[std::size_t(j)]; });
  return order;
}

}  // namespace

bool WantsContacts(const btIDebugDraw* drawer) {
  constexpr int kContacts = btIDebugDraw::DBG_DrawContactPoints | btIDebugDraw::DBG_DrawText;
  return drawer != nullptr && (drawer->getDebugMode() & kContacts) != 0;
}

void DrawContacts(const dgd::ContactPatch<double>& patch, const dgd::Result<double>& result, btIDebugDraw& drawer) {
  if (patch.size == 0) return;
  const int mode = drawer.getDebugMode();
  if ((mode & btIDebugDraw::DBG_DrawContactPoints) != 0) {
    const auto order = Around(patch, result.normal);
    for (int i = 0; i < patch.size; ++i) {
      const auto& point = patch.points[std::size_t(order[std::size_t(i)])];
      const auto& next = patch.points[std::size_t(order[std::size_t((i + 1) % patch.size)])];
      drawer.drawLine(ToBullet(point.on_1), ToBullet(next.on_1), kOutlineColor);
      drawer.drawLine(ToBullet(point.on_2), ToBullet(next.on_2), kOutlineColor);
      drawer.drawLine(ToBullet(point.on_2), ToBullet(point.on_2 - kNormalLength * result.normal), kNormalColor);
    }
  }
  if ((mode & btIDebugDraw::DBG_DrawText) != 0) {
    std::array<char, 96> text{};
    const double millimetres = 1000 * patch.points[0].separation;
    if (std::isfinite(result.upper_bound)) {
      std::snprintf(text.data(), text.size(), "%+.3g mm, growth distance %.9g to %.9g", millimetres, result.lower_bound,
                    result.upper_bound);
    } else {
      std::snprintf(text.data(), text.size(), "%+.3g mm", millimetres);
    }
    drawer.draw3dText(ToBullet(patch.points[0].on_2), text.data());
  }
}

}  // namespace dgd_bullet
