// A triangle: flat, so it has no growth distance to another flat set unless one of the two has a radius.
#pragma once

#include <algorithm>
#include <array>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"

namespace dgd {

/// The point of triangle (a, b, c) nearest to `point`, which may be degenerate: to a segment or a point. The plane's
/// interior and the three edges, all of them: on a sliver, the plane's point has lost its digits and an edge is nearer.
/// The naive way, kept for its certainty.
template <class S>
Vector3<S> ClosestPointOnTriangle(const Vector3<S>& point, const Vector3<S>& a, const Vector3<S>& b,
                                  const Vector3<S>& c) {
  Vector3<S> nearest = a;
  const Vector3<S> normal = (b - a).cross(c - a);
  const S area_sq = normal.squaredNorm();
  if (area_sq > 0) {
    const S weight_a = normal.dot((b - point).cross(c - point));
    const S weight_b = normal.dot((c - point).cross(a - point));
    const S weight_c = normal.dot((a - point).cross(b - point));
    if (weight_a >= 0 && weight_b >= 0 && weight_c >= 0) {
      nearest = point - normal * (normal.dot(point - a) / area_sq);
    }
  }
  const std::array<const Vector3<S>*, 4> loop{&a, &b, &c, &a};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<S> edge = *loop[i + 1] - *loop[i];
    const S length_sq = edge.squaredNorm();
    const S along = length_sq > 0 ? std::clamp(edge.dot(point - *loop[i]) / length_sq, S(0), S(1)) : S(0);
    const Vector3<S> candidate = *loop[i] + along * edge;
    if ((candidate - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = candidate;
  }
  return nearest;
}

template <class S>
class Triangle {
 public:
  using Scalar = S;

  /// @param a, b, c  Corners, metres; collinear or equal corners are allowed and make a segment or a point.
  Triangle(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c)
      : corners_{RequireFinite(a, "triangle corner"), RequireFinite(b, "triangle corner"),
                 RequireFinite(c, "triangle corner")},
        center_((a + b + c) / S(3)) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    const S height_0 = direction.dot(corners_[0]);
    const S height_1 = direction.dot(corners_[1]);
    const S height_2 = direction.dot(corners_[2]);
    const VertexId best = height_0 >= height_1 ? (height_0 >= height_2 ? 0 : 2) : (height_1 >= height_2 ? 1 : 2);
    return {corners_[best], best};
  }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return 0; }
  /// See CenteredCore. The partner's interior, or a radius, makes up for a centre on the border.
  void MoveCenterNear(const Vector3<S>& point) {
    center_ = ClosestPointOnTriangle(point, corners_[0], corners_[1], corners_[2]);
  }

  const Vector3<S>& Vertex(VertexId corner) const {
    DGD_ASSERT(corner < 3);
    return corners_[corner];
  }
  VertexId VertexCount() const { return 3; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    return std::max({direction.dot(corners_[0]), direction.dot(corners_[1]), direction.dot(corners_[2])});
  }

  /// Distance of `point` to the core, metres; 0 on it.
  S Distance(const Vector3<S>& point) const {
    return (ClosestPointOnTriangle(point, corners_[0], corners_[1], corners_[2]) - point).norm();
  }

  void SupportFace(const Vector3<S>&, SupportingFace<S>& face) const {
    for (const Vector3<S>& corner : corners_) face.Add(corner);
  }

 private:
  std::array<Vector3<S>, 3> corners_;
  Vector3<S> center_;
};

}  // namespace dgd
