// What of a parallelogram is above a rectangle: the corners of the overlap of two boxes' faces.
//
// For two such figures the corners can be listed without clipping one side after the other: each side of the
// parallelogram enters and leaves the rectangle at most once, and what else is a corner is one of the rectangle's. All
// of it is computed, and kept or not, without a branch: which sides cross is another matter for each pair of boxes.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dgd/types.h"

namespace dgd {

/// A parallelogram in space: its middle, and half of two neighbouring sides, of any length, also 0. Metres; in a frame
/// along whose z axis it is seen.
template <class S>
struct Parallelogram {
  Vector3<S> middle, half_a, half_b;
};

/// The corners of an overlap, in the parallelogram's frame, metres.
template <class S>
struct RectangleOverlap {
  /// Two of each side, and the rectangle's four.
  static constexpr int kMaxCorners = 12;

  void AddIf(bool is_corner, S x, S y, S z) {
    corners[static_cast<std::size_t>(size)] = {x, y, z};
    size += is_corner ? 1 : 0;
  }

  /// On the parallelogram. One more than there can be: where the next one is tried.
  std::array<Vector3<S>, kMaxCorners + 1> corners;
  int size = 0;
};

namespace rectangle_overlap_internal {

/// Of a parallelogram's sides each, or of a rectangle's corners.
template <class S>
using Four = Eigen::Array<S, 4, 1>;

/// The ends of what the rectangle has of the parallelogram's sides.
template <class S>
void AddSides(const Parallelogram<S>& shape, S half_x, S half_y, RectangleOverlap<S>& overlap) {
  using Sides = Four<S>;
  const Vector3<S>&m = shape.middle, &a = shape.half_a, &b = shape.half_b;
  // Where each side begins, and the way to its end.
  const auto begins = [&](int axis) -> Sides {
    const S sum = a[axis] + b[axis], difference = a[axis] - b[axis];
    return m[axis] + Sides(sum, -difference, -sum, difference);
  };
  const auto ways = [&](int axis) -> Sides { return Sides(-2 * a[axis], -2 * b[axis], 2 * a[axis], 2 * b[axis]); };
  const Sides x = begins(0), y = begins(1), z = begins(2), way_x = ways(0), way_y = ways(1), way_z = ways(2);

  // Between which parts of its way a side is inside: of a side along the rectangle's, all of it or none.
  Sides from = Sides::Zero(), to = Sides::Ones();
  const auto keep_inside = [&](const Sides& begin, S way_a, S way_b, S half) {
    const S no_way = std::sqrt(std::sqrt(std::numeric_limits<S>::min()));
    const S per_a = 1 / std::copysign(std::max(2 * std::abs(way_a), no_way), way_a);
    const S per_b = 1 / std::copysign(std::max(2 * std::abs(way_b), no_way), way_b);
    const Sides per_way(-per_a, -per_b, per_a, per_b);
    const Sides one = (-half - begin) * per_way, other = (half - begin) * per_way;
    from = from.max(one.min(other));
    to = to.min(one.max(other));
  };
  keep_inside(x, a.x(), b.x(), half_x);
  keep_inside(y, a.y(), b.y(), half_y);
  const Sides from_x = x + from * way_x, from_y = y + from * way_y, from_z = z + from * way_z;
  const Sides to_x = x + to * way_x, to_y = y + to * way_y, to_z = z + to * way_z;
  for (int i = 0; i < 4; ++i) {
    overlap.AddIf(from[i] <= to[i], from_x[i], from_y[i], from_z[i]);
    // An end that is inside is where the next side begins, if rounding says so, too.
    const int next = (i + 1) % 4;
    const bool is_whole = to[i] == 1, next_is_from_start = from[next] == 0, next_is_inside = to[next] >= 0;
    const bool is_next = is_whole & next_is_from_start & next_is_inside, has_length = from[i] < to[i];
    overlap.AddIf(has_length & !is_next, to_x[i], to_y[i], to_z[i]);
  }
}

/// The rectangle's corners that the parallelogram has: by their coordinates along its half sides.
template <class S>
void AddCorners(const Parallelogram<S>& shape, S half_x, S half_y, RectangleOverlap<S>& overlap) {
  using Corners = Four<S>;
  const Vector3<S>&m = shape.middle, &a = shape.half_a, &b = shape.half_b;
  const Corners x(half_x, -half_x, -half_x, half_x), y(half_y, half_y, -half_y, -half_y);
  // Times the area.
  const Corners along_a = (x - m.x()) * b.y() - (y - m.y()) * b.x();
  const Corners along_b = (y - m.y()) * a.x() - (x - m.x()) * a.y();
  const S area = a.x() * b.y() - a.y() * b.x();
  const bool is_flat = area == 0;
  const S per_area = 1 / (is_flat ? S(1) : area);
  const auto within = [](const Corners& along) -> Corners { return along.max(S(-1)).min(S(1)); };
  const Corners z = m.z() + within(along_a * per_area) * a.z() + within(along_b * per_area) * b.z();
  // A corner that rounding leaves outside would be missed, for the sides that meet there may be left outside, too. Some
  // of the last digits of each product.
  constexpr S kRounding = 16 * std::numeric_limits<S>::epsilon();
  const S far_x = half_x + std::abs(m.x()), far_y = half_y + std::abs(m.y());
  const S reach_a = std::abs(area) + kRounding * (far_x * std::abs(b.y()) + far_y * std::abs(b.x()));
  const S reach_b = std::abs(area) + kRounding * (far_y * std::abs(a.x()) + far_x * std::abs(a.y()));
  for (int i = 0; i < 4; ++i) {
    const bool is_inside_a = std::abs(along_a[i]) <= reach_a, is_inside_b = std::abs(along_b[i]) <= reach_b;
    overlap.AddIf(is_inside_a & is_inside_b & !is_flat, x[i], y[i], z[i]);
  }
}

}  // namespace rectangle_overlap_internal

/// The part of a parallelogram that is seen inside a rectangle, along z: |x| <= half_x, |y| <= half_y. Its corners,
/// some perhaps twice within rounding: those on the parallelogram's sides in order, then those of the rectangle.
/// @param shape           Finite.
/// @param half_x, half_y  Metres, finite, >= 0.
/// Does not divide by zero, allocate or throw.
template <class S>
RectangleOverlap<S> OverlapWithRectangle(const Parallelogram<S>& shape, S half_x, S half_y) {
  RectangleOverlap<S> overlap;
  rectangle_overlap_internal::AddSides(shape, half_x, half_y, overlap);
  rectangle_overlap_internal::AddCorners(shape, half_x, half_y, overlap);
  return overlap;
}

}  // namespace dgd
