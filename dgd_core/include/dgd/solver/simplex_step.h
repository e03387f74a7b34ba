// The paper's simplex step (Sec. III-C2) on a triangle in space: which corner a new point replaces, and where the ray
// passes the triangle that this makes. Plain arithmetic, for the many steps about which nothing is uncertain.
//
// All coordinates are in the ray frame, metres: the ray is the z axis, x and y run across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "dgd/assert.h"
#include "dgd/solver/tolerances.h"
#include "dgd/solver/triangle_crossing.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// The corner that a new point most likely replaces: the one whose wedge, seen along the ray and turned by half a turn,
/// does not hold the point.
/// @param turns  Twice the signed areas of the ray, the new point and each corner; corners counterclockwise.
template <class S>
std::size_t OutgoingCorner(const std::array<S, 3>& turns) {
  if (turns[0] >= 0 && turns[1] <= 0) return 2;
  if (turns[1] >= 0 && turns[2] <= 0) return 0;
  return 1;
}

/// A new point for one of a triangle's corners. Look at is_certain first: else the ray may pass another triangle.
/// @tparam kHasRadius  Whether there is a radius.
template <class S, bool kHasRadius>
struct SimplexStep {
  /// @param corners   Counterclockwise about the ray, which passes between them once they are moved by the radius
  ///                  `convex_radius` along `old_normal`.
  SimplexStep(const std::array<const Vector3<S>*, 3>& corners, const Vector3<S>& added, S convex_radius,
              const Vector3<S>& old_normal) {
    const Vector3<S> old_shift = convex_radius * old_normal;
    const MovedPoint w = Moved(added, old_shift);
    const auto turn = [&](std::size_t i) { return Cross<S>(w, Moved(*corners[i], old_shift)); };
    const std::array<S, 3> turns = {turn(0), turn(1), turn(2)};
    outgoing = OutgoingCorner(turns);
    next = outgoing == 2 ? 0 : outgoing + 1;
    last = outgoing == 0 ? 2 : outgoing - 1;
    DGD_ASSERT(outgoing < 3 && next < 3 && last < 3);
    direction = (*corners[last] - *corners[next]).cross(added - *corners[next]);
    // A triangle that is a line, or one seen edge-on, has no weights to be certain of.
    is_certain = false;
    const S twice_area = direction.norm();
    if (!(twice_area > 0)) return;
    normal = 1 / twice_area * direction;

    const Vector3<S> shift = convex_radius * normal;
    const MovedPoint a = Moved(*corners[next], shift), b = Moved(*corners[last], shift), c = Moved(added, shift);
    // Without a radius the ratio test has worked out two of the three areas already.
    const S area_added = Cross(a, b);
    const S area_a = kHasRadius ? Cross(b, c) : -turns[last], area_b = kHasRadius ? Cross(c, a) : turns[next];
    const S area = area_added + area_a + area_b;
    if (!(area > 0)) return;
    const S per_area = 1 / area;
    weights = {area_added * per_area, area_a * per_area, area_b * per_area};
    height = weights[0] * c.z() + weights[1] * a.z() + weights[2] * b.z();

    const S reach = std::max({LateralL1(a), LateralL1(b), LateralL1(c)});
    is_certain = std::min({area_added, area_a, area_b}) > kWeightSlack<S> * reach * (reach + convex_radius) &&
                 area > kSliver<S> * reach * reach && normal.z() > kSteep<S> &&
                 direction.dot(*corners[outgoing] - added) <= 0;
  }

  /// Points are as they are where there is no radius to move them by.
  using MovedPoint = std::conditional_t<kHasRadius, Vector3<S>, const Vector3<S>&>;
  static MovedPoint Moved(const Vector3<S>& point, [[maybe_unused]] const Vector3<S>& shift) {
    if constexpr (kHasRadius) {
      return point + shift;
    } else {
      return point;
    }
  }

  std::size_t outgoing;      // The corner that the new point replaces; it lies below the new triangle if certain.
  std::size_t next, last;    // The other two: the new point, these, counterclockwise.
  std::array<S, 3> weights;  // Convex, of the new point, `next`, `last`.
  S height;                  // Height at which the ray passes the moved triangle, metres.
  Vector3<S> normal;         // Unit length, upwards.
  Vector3<S> direction;      // The normal's, of any length: known before that is.
  bool is_certain;           // The ray passes inside the border, and the triangle is no sliver and not steep.
};

}  // namespace dgd::solver_internal
