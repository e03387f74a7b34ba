// Where the ray passes a triangle of the inner approximation: barycentric weights and normal, the plain way and, for
// slivers, so that they keep their digits.
//
// All coordinates are in the ray frame, metres: the ray is the z axis, x and y run across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// Twice the signed area of the origin, a and b seen along the ray, square metres.
template <class S>
S Cross(const Vector3<S>& a, const Vector3<S>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Distance from the ray, metres, but for a factor of up to sqrt(2).
template <class S>
S LateralL1(const Vector3<S>& a) {
  return std::abs(a.x()) + std::abs(a.y());
}

/// Whether the ray passes through a triangle.
enum class Crossing { kNo, kYes, kUncertain };

/// Barycentric weights of the ray in a triangle seen along it, the plain way: uncertain where the ray passes an edge
/// within roundoff.
/// @param roundoff  Of twice an area, square metres.
template <class S>
Crossing Weigh(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c, S convex_radius,
               std::array<S, 3>& weights) {
  weights = {Cross(b, c), Cross(c, a), Cross(a, b)};
  const S per_area = 1 / (weights[0] + weights[1] + weights[2]);
  for (S& weight : weights) weight *= per_area;
  const S least = std::min({weights[0], weights[1], weights[2]});
  const S uncertainty = convex_radius * std::abs(per_area);
  return least > uncertainty ? Crossing::kYes : least < -uncertainty ? Crossing::kNo : Crossing::kUncertain;
}

/// Twice the signed area of the ray and an edge seen along the ray, counterclockwise positive, and what its roundoff
/// error is epsilon times of. From the corner opposite the longest side of the three, so that neither two far points
/// close together nor one far and one near point cost digits. Depends on the edge alone: neighbouring triangles agree
/// about which side of it the ray is on.
template <class S>
struct EdgeArea {
  EdgeArea(const Vector3<S>& a, const Vector3<S>& b) {
    const Vector3<S> d = b - a;
    const S length_a = LateralL1(a), length_b = LateralL1(b), length_d = LateralL1(d);
    length = length_d;
    if (length_d >= length_a && length_d >= length_b) {
      value = Cross(a, b);
      scale = length_a * length_b;
    } else if (length_a >= length_b) {
      value = Cross(b, d);
      scale = length_b * length_d;
    } else {
      value = Cross(a, d);
      scale = length_a * length_d;
    }
  }
  S value, scale;  // Square metres.
  S length;        // Length of the edge across the ray, by LateralL1(), metres.
};

/// The same as Weigh(), for slivers: one long side and little area, where plain sums and differences lose most digits.
/// @param area          Twice the triangle's seen along the ray, from its sides: the three edge areas may cancel.
/// @param border_error  How far the border may be off, metres.
template <class S>
bool WeighSliver(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c, S area, S border_error,
                 std::array<S, 3>& weights) {
  const EdgeArea<S> edges[3] = {{b, c}, {c, a}, {a, b}};
  const S sign = edges[0].value + edges[1].value + edges[2].value < 0 ? S(-1) : S(1);
  for (std::size_t k = 0; k < 3; ++k) {
    const S slack = kWeightSlack<S> * edges[k].scale + border_error * edges[k].length;
    if (!(sign * edges[k].value >= -slack)) return false;
    weights[k] = std::max(S(0), sign * edges[k].value / area);
  }
  // The weights' sum carries the error of the least certain ones; they share it, so that the rest keep their digits.
  std::size_t first = edges[0].scale >= edges[1].scale ? 0 : 1, second = 1 - first;
  if (edges[2].scale > edges[second].scale) second = 2;
  if (edges[second].scale > edges[first].scale) std::swap(first, second);
  S& others = weights[3 - first - second];
  others = std::min(others, S(1));
  weights[first] = 1 - others - weights[second];
  if (weights[first] < 0) {
    weights[first] = 0;
    weights[second] = 1 - others;
  }
  return true;
}

/// Shifts weight from one end of a side to the other, to where the weighted sum of the corners is nearest to its
/// target.
/// @param off  The sum less the target, metres.
template <class S, int D>
void MoveAlongSide(const Vector<S, D>& side, const Vector<S, D>& off, S& weight_from, S& weight_to) {
  const S length_sq = side.squaredNorm();
  if (!(length_sq > 0)) return;
  const S shift = std::clamp(off.dot(side) / length_sq, -weight_from, weight_to);
  weight_from += shift;
  weight_to -= shift;
}

/// The side from corner i to the next that is longest.
template <class S, int D>
std::size_t LongestSide(const std::array<Vector<S, D>, 3>& corners) {
  const auto length_sq = [&](std::size_t i) { return (corners[(i + 1) % 3] - corners[i]).squaredNorm(); };
  std::size_t longest = length_sq(0) >= length_sq(1) ? 0 : 1;
  return length_sq(2) > length_sq(longest) ? 2 : longest;
}

/// How far the weighted sum of the corners is off its target, metres.
template <class S, int D>
Vector<S, D> OffTarget(const std::array<Vector<S, D>, 3>& corners, const std::array<S, 3>& weights,
                       const Vector<S, D>& target) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - target;
}

/// The flatter a sliver, the fewer digits its weights have; but what they are off by runs along its longest side, and a
/// shift of weight from one end of that to the other takes it away. Where an end has no weight to give, the other two
/// sides, which run nearly the same way, do the rest. Test: SliverExit.WeightsOffAlongASideButTheLongest_*.
/// @param target  What the weighted sum of the corners is to come near to, metres.
template <class S, int D>
void MoveAlongSides(const std::array<Vector<S, D>, 3>& corners, const Vector<S, D>& target, std::array<S, 3>& weights) {
  const std::size_t longest = LongestSide<S, D>(corners);
  for (std::size_t i = longest; i < longest + 3; ++i) {
    const std::size_t from = i % 3, to = (i + 1) % 3;
    const Vector<S, D> off = OffTarget(corners, weights, target);
    MoveAlongSide<S, D>(corners[to] - corners[from], off, weights[from], weights[to]);
  }
}

/// Shifts weight between the longest side and the corner opposite, as far as the weights allow.
template <class S, int D>
void MoveFromLongestSide(const std::array<Vector<S, D>, 3>& corners, const Vector<S, D>& target,
                         std::array<S, 3>& weights) {
  const std::size_t from = LongestSide<S, D>(corners), to = (from + 1) % 3, top = (from + 2) % 3;
  const Vector<S, D> side = corners[to] - corners[from], slanted = corners[top] - corners[from];
  const S length_sq = side.squaredNorm();
  if (!(length_sq > 0)) return;  // Corners in a point.
  // The foot of the corner's altitude is on the longest side.
  const S foot = std::clamp(slanted.dot(side) / length_sq, S(0), S(1));
  const Vector<S, D> altitude = slanted - foot * side;
  const S altitude_sq = altitude.squaredNorm();
  if (!(altitude_sq > 0)) return;  // Corners on a line.
  const Vector<S, D> off = OffTarget(corners, weights, target);
  S shift = std::max(-weights[top], -off.dot(altitude) / altitude_sq);
  if (foot < 1) shift = std::min(shift, weights[from] / (1 - foot));
  if (foot > 0) shift = std::min(shift, weights[to] / foot);
  if (!std::isfinite(shift)) return;  // Corners nearly on a line.
  weights[top] += shift;
  weights[from] -= shift * (1 - foot);
  weights[to] -= shift * foot;
}

/// Normal of a sliver, from the corner opposite its longest side; see EdgeArea.
template <class S>
struct SliverNormal {
  SliverNormal(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c) {
    const Vector3<S> ab = b - a, bc = c - b, ca = a - c;
    const S length_ab = ab.squaredNorm(), length_bc = bc.squaredNorm(), length_ca = ca.squaredNorm();
    const S longest = std::max({length_ab, length_bc, length_ca});
    const bool is_ab = longest == length_ab, is_bc = !is_ab && longest == length_bc;
    cross = is_ab ? bc.cross(ca) : is_bc ? ca.cross(ab) : ab.cross(bc);
    short_sides_sq = is_ab ? length_bc * length_ca : is_bc ? length_ca * length_ab : length_ab * length_bc;
  }

  /// Error of the unit normal, radians: the flatter the corner, the larger. For a sliver that has an area.
  S Error() const { return kWeightSlack<S> * std::sqrt(short_sides_sq / cross.squaredNorm()); }

  Vector3<S> cross;  // As long as twice the sliver's area.
  S short_sides_sq;  // Product of their squared lengths.
};

}  // namespace dgd::solver_internal
