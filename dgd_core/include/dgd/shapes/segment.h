// A segment along its frame's last axis (z, in the plane y), centred; with a radius, a capsule or a stadium.
#pragma once

#include <algorithm>
#include <cmath>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"

namespace dgd {

template <class S, int L = 3>
class Segment {
 public:
  using Scalar = S;

  /// @param half_length  Metres, >= 0: the end points are +-half_length on the last axis.
  explicit Segment(S half_length) : half_length_(RequireLength(half_length, true, "segment half length")) {}

  SupportPoint<S, L> Support(const Vector<S, L>& direction) const {
    const VertexId end = direction[L - 1] < 0;
    return {Vertex(end), end};
  }
  Vector<S, L> Center() const { return OnAxis(center_); }
  /// See CenteredCore.
  void MoveCenterNear(const Vector<S, L>& point) { center_ = std::clamp(point[L - 1], -half_length_, half_length_); }
  S Inradius() const { return 0; }
  /// See SpreadCore.
  auto Spread() const { return SpreadOfExtents<S, L>(Vector<S, L>::Unit(L - 1) * half_length_); }

  Vector<S, L> Vertex(VertexId end) const { return OnAxis(end == 0 ? half_length_ : -half_length_); }
  VertexId VertexCount() const { return 2; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector<S, L>& direction) const { return half_length_ * std::abs(direction[L - 1]); }

  /// Distance of `point` to the core, metres; 0 on it.
  S Distance(const Vector<S, L>& point) const {
    return (point - OnAxis(std::clamp(point[L - 1], -half_length_, half_length_))).norm();
  }

  void SupportFace(const Vector<S, L>&, SupportingFace<S>& face) const requires(L == 3) {
    face.Add(Vertex(0));
    face.Add(Vertex(1));
  }

 private:
  static Vector<S, L> OnAxis(S height) {
    Vector<S, L> point = Vector<S, L>::Zero();
    point[L - 1] = height;
    return point;
  }

  S half_length_;
  S center_ = 0;
};

}  // namespace dgd
