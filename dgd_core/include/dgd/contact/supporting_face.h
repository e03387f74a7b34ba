// The flat part of a core's surface that faces a direction: what two bodies in contact lie on.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "dgd/assert.h"
#include "dgd/types.h"

namespace dgd {

/// A convex polygon (three points or more, in order around it), a segment (two), a point (one), or nothing where the
/// core has no faces; in the core's frame. It holds the support point along its direction, or a point of the same
/// height within the core's own discretisation (discs are given as inscribed polygons).
template <class Scalar>
struct SupportingFace {
  /// A facet with more vertices is thinned to so many: enough for a disc whose rim deviates by 2 % of its radius.
  static constexpr int kMaxPoints = 16;

  std::array<Vector3<Scalar>, kMaxPoints> points;
  int size = 0;
  /// Radius of the surface's curve across a segment, metres. 0 for a sharp edge, and a safe choice.
  Scalar radius = 0;

  /// Newell's normal, twice the area long: by the right hand, as the points run around it.
  Vector3<Scalar> Area() const {
    Vector3<Scalar> area = Vector3<Scalar>::Zero();
    for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(size); ++i) {
      area += (points[i] - points[0]).cross(points[i + 1] - points[0]);
    }
    return area;
  }

  void Add(const Vector3<Scalar>& point) {
    DGD_ASSERT(size >= 0 && size < kMaxPoints);
    points[static_cast<std::size_t>(size++)] = point;
  }
};

}  // namespace dgd
