// Where the ray leaves the offset of one feature of the inner approximation: a vertex, an edge, or a facet (a triangle
// in space, a segment in the plane).
//
// All coordinates are in the ray frame, metres: the last one is the height along the ray, those before run across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/solver/tolerances.h"
#include "dgd/solver/triangle_crossing.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// Each function below fills all of it and returns true, or returns false where the ray passes the feature by.
template <class S, int L>
struct FeatureExit {
  S height = -1;  // Below any real one: no exit found.
  Vector<S, L> normal = Vector<S, L>::Unit(L - 1);
  Vector<S, L> direction = Vector<S, L>::Unit(L - 1);  // The normal's, of any length: known before that is.
  std::array<S, L> weights{};                          // Convex weights of the feature's points.
  int size = 0;
  bool is_rough = false;  // The feature's point may be off the ray by more than the weights' last digits.
};

/// Sets direction and normal from a vector along a facet's normal, either way; false if the ray sees the facet edge-on.
template <class S, int L>
bool PointUpwards(const Vector<S, L>& along, FeatureExit<S, L>& exit) {
  exit.direction = std::copysign(S(1), along[L - 1]) * along;
  const S length = exit.direction.norm();
  if (!(length > 0)) return false;
  exit.normal = 1 / length * exit.direction;
  return exit.normal[L - 1] > 0;
}

template <class S>
void SetTriangleHeight(S a, S b, S c, FeatureExit<S, 3>& exit) {
  exit.height = exit.weights[0] * a + exit.weights[1] * b + exit.weights[2] * c;
  exit.size = 3;
}

/// The same as FacetExit(), for slivers and for rays along a border: the basis changes there by the last digits, and
/// all triangles on an edge must agree about the side of it on which the ray is.
/// @param corner_error  How far the corners may be off across the ray, metres: where that is not 0, several triangles
///                      may claim the ray.
template <class S>
DGD_COLD bool SliverExit(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c, S convex_radius, S corner_error,
                         FeatureExit<S, 3>& exit) {
  const SliverNormal<S> normal(a, b, c);
  if (!PointUpwards<S, 3>(normal.cross, exit)) return false;
  const Vector3<S> shift = convex_radius * exit.normal;
  const Vector3<S> shifted_a = a + shift, shifted_b = b + shift, shifted_c = c + shift;
  const S area = std::abs(normal.cross.z()), border_error = convex_radius * normal.Error() + corner_error;
  if (!WeighSliver(shifted_a, shifted_b, shifted_c, area, border_error, exit.weights)) return false;
  MoveAlongSides<S, 2>({shifted_a.template head<2>(), shifted_b.template head<2>(), shifted_c.template head<2>()},
                       Vector2<S>::Zero(), exit.weights);
  // Corners on a line, but for roundoff, leave the weights no digits: then they do not make a point of the ray. The
  // corners' error counts as well: it is of all their coordinates, and the sliver may be near the ray with all of it.
  const Vector3<S> on_ray = exit.weights[0] * shifted_a + exit.weights[1] * shifted_b + exit.weights[2] * shifted_c;
  const S reach = std::max({LateralL1<S>(shifted_a), LateralL1<S>(shifted_b), LateralL1<S>(shifted_c)});
  if (!(LateralL1<S>(on_ray) <= kOffRay<S> * (reach + convex_radius) + corner_error)) return false;
  SetTriangleHeight(shifted_a.z(), shifted_b.z(), shifted_c.z(), exit);
  exit.is_rough = true;
  return true;
}

/// Offset triangle: the plane through a, b and c, moved by R along its normal; false if the ray passes it by, or sees
/// it edge-on. Computed the plain way first, and with care where that is not certain.
template <class S>
bool FacetExit(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c, S convex_radius,
               FeatureExit<S, 3>& exit) {
  const Vector3<S> cross = (b - a).cross(c - a);
  const S area = std::abs(cross.z());
  if (!PointUpwards<S, 3>(cross, exit)) return SliverExit(a, b, c, convex_radius, S(0), exit);
  // The plane moves sideways by the normal's lateral part, and the triangle's border with it.
  const Vector3<S> shift = convex_radius * exit.normal;
  const Vector3<S> shifted_a = a + shift, shifted_b = b + shift, shifted_c = c + shift;
  const S reach = std::max({LateralL1<S>(shifted_a), LateralL1<S>(shifted_b), LateralL1<S>(shifted_c)});
  if (!(area > kSliver<S> * reach * reach)) return SliverExit(a, b, c, convex_radius, S(0), exit);
  switch (Weigh(shifted_a, shifted_b, shifted_c, kWeightSlack<S> * reach * (reach + convex_radius), exit.weights)) {
    case Crossing::kNo:
      return false;
    case Crossing::kUncertain:
      return SliverExit(a, b, c, convex_radius, S(0), exit);
    case Crossing::kYes:
      SetTriangleHeight(shifted_a.z(), shifted_b.z(), shifted_c.z(), exit);
  }
  return true;
}

/// Offset edge: the cylinder about the segment from a to b.
template <class S>
bool EdgeExit(const Vector3<S>& a, const Vector3<S>& b, S convex_radius, FeatureExit<S, 3>& exit) {
  DGD_ASSERT(!(convex_radius < 0));
  const Vector3<S> d = b - a;
  const S lateral_sq = d.x() * d.x() + d.y() * d.y();
  if (!(lateral_sq > 0)) return false;  // Along the ray: its upper end is higher.
  // Nearest approach of the edge's line to the ray, at parameter t0, and the offset's half width there.
  const S cross = Cross<S>(a, d);
  const S half_width_sq = convex_radius * convex_radius - cross * cross / lateral_sq;
  if (!(half_width_sq > 0)) return false;
  const S t0 = -(a.x() * d.x() + a.y() * d.y()) / lateral_sq;
  const S length = std::sqrt(lateral_sq + d.z() * d.z());
  const S lateral = std::sqrt(lateral_sq);
  const S half_width = std::sqrt(half_width_sq);
  S t = t0 + half_width * d.z() / (lateral * length);
  if (!(t >= -kWeightSlack<S> && t <= 1 + kWeightSlack<S>)) return false;
  t = t < 0 ? S(0) : t > 1 ? S(1) : t;
  exit.height = a.z() + t0 * d.z() + half_width * length / lateral;
  // The normal has a part across the edge and the ray, and a part in their plane: it is orthogonal to the edge to the
  // last digit also where the radius is small, which -(a + t * d) / R is not.
  const S across = cross / (convex_radius * lateral_sq);
  const S along = -half_width * d.z() / (convex_radius * lateral * length);
  exit.normal = {along * d.x() - across * d.y(), along * d.y() + across * d.x(),
                 half_width * lateral / (convex_radius * length)};
  exit.direction = exit.normal;
  exit.weights = {1 - t, t, 0};
  exit.size = 2;
  return true;
}

/// Offset segment in the plane: the line through a and b, moved by R along its normal.
template <class S>
bool FacetExit(const Vector2<S>& a, const Vector2<S>& b, S convex_radius, FeatureExit<S, 2>& exit) {
  const Vector2<S> d = b - a;
  if (!PointUpwards<S, 2>({-d.y(), d.x()}, exit)) return false;
  const Vector2<S> shift = convex_radius * exit.normal;
  const S across_a = a.x() + shift.x(), across_b = b.x() + shift.x();
  // Without a radius the sign of a point's coordinate decides, and neighbouring segments agree about it.
  const S slack =
      convex_radius > 0 ? kWeightSlack<S> * (std::abs(across_a) + std::abs(across_b) + convex_radius) : S(0);
  const S side = d.x() > 0 ? S(1) : S(-1);
  if (!(side * across_a <= slack && side * across_b >= -slack)) return false;
  const S weight_b = std::clamp(-across_a / d.x(), S(0), S(1));
  exit.weights = {1 - weight_b, weight_b};
  // The height is counted from the nearer end, so that a far one costs no digits.
  const S slope = d.y() / d.x();
  exit.height = std::abs(across_a) < std::abs(across_b) ? a.y() + shift.y() - slope * across_a
                                                        : b.y() + shift.y() - slope * across_b;
  exit.size = 2;
  return true;
}

/// Offset vertex: the ball about a.
template <class S, int L>
bool VertexExit(const Vector<S, L>& a, S convex_radius, FeatureExit<S, L>& exit) {
  DGD_ASSERT(!(convex_radius < 0));
  const Vector<S, L - 1> across = a.template head<L - 1>();
  const S half_width_sq = convex_radius * convex_radius - across.squaredNorm();
  if (!(half_width_sq > 0)) return false;
  const S half_width = std::sqrt(half_width_sq);
  exit.height = a[L - 1] + half_width;
  exit.normal.template head<L - 1>() = -across / convex_radius;
  exit.normal[L - 1] = half_width / convex_radius;
  exit.direction = exit.normal;
  exit.weights = {1};
  exit.size = 1;
  return true;
}

}  // namespace dgd::solver_internal
