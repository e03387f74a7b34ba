#include "posed_shape.h"

#include <array>
#include <type_traits>

namespace dgd_bullet {
namespace {

/// Whether the centre can move, for each alternative of the set.
constexpr auto kIsCentered = []<class... Sets>(std::type_identity<std::variant<Sets...>>) {
  return std::array{dgd::CenteredCore<typename Sets::Core>...};
}(std::type_identity<ShapeSet>());

bool IsCentered(const PosedShape& shape) { return kIsCentered[shape.set.index()]; }

void MoveCenterNear(const Vector3& point, PosedShape& shape) {
  std::visit(
      [&](auto& set) {
        if constexpr (dgd::CenteredCore<std::remove_cvref_t<decltype(set.core)>>) {
          set.core.MoveCenterNear(shape.pose.rotation.transpose() * (point - shape.pose.translation));
        }
      },
      shape.set);
}

}  // namespace

Vector3 CenterOf(const PosedShape& shape) {
  return std::visit([&](const auto& set) -> Vector3 { return shape.pose * set.core.Center(); }, shape.set);
}

Vector3 SupportPoint(const PosedShape& shape, const Vector3& direction) {
  const Vector3 local = shape.pose.rotation.transpose() * direction;
  return std::visit(
      [&](const auto& set) -> Vector3 { return shape.pose * set.core.Support(local).point + set.radius * direction; },
      shape.set);
}

void MoveCentersTogether(PosedShape& shape_a, PosedShape& shape_b) {
  if (!IsCentered(shape_a) && !IsCentered(shape_b)) return;  // Two hulls.
  // Both from where they were, so that the order of the two does not matter.
  const Vector3 center_a = CenterOf(shape_a), center_b = CenterOf(shape_b);
  MoveCenterNear(center_b, shape_a);
  MoveCenterNear(center_a, shape_b);
}

}  // namespace dgd_bullet
