// A box, aligned with its frame's axes and centred; in the plane, a rectangle.
#pragma once

#include <cmath>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"

namespace dgd {

template <class S, int L = 3>
class Box {
 public:
  using Scalar = S;

  /// @param half_extents  Metres, each >= 0; a zero makes a rectangle, a segment or a point.
  explicit Box(const Vector<S, L>& half_extents) : half_extents_(half_extents) {
    for (int axis = 0; axis < L; ++axis) RequireLength(half_extents[axis], true, "box half extent");
  }

  SupportPoint<S, L> Support(const Vector<S, L>& direction) const {
    // The sign bit, as copysign() reads it: -0 counts as negative in both.
    SupportPoint<S, L> support{half_extents_, 0};
    for (int axis = 0; axis < L; ++axis) {
      support.point[axis] = std::copysign(half_extents_[axis], direction[axis]);
      support.feature |= VertexId(std::signbit(direction[axis])) << axis;
    }
    return support;
  }
  const Vector<S, L>& HalfExtents() const { return half_extents_; }
  const Vector<S, L>& Center() const { return center_; }
  S Inradius() const { return half_extents_.minCoeff(); }
  /// See SpreadCore.
  auto Spread() const { return SpreadOfExtents<S, L>(half_extents_); }
  /// See CenteredCore.
  void MoveCenterNear(const Vector<S, L>& point) {
    const Vector<S, L> reach = half_extents_.array() - Inradius();
    center_ = point.cwiseMax(-reach).cwiseMin(reach);
  }

  /// Bit i of `corner` is set where coordinate i is negative.
  Vector<S, L> Vertex(VertexId corner) const {
    DGD_ASSERT(corner < VertexCount());
    Vector<S, L> vertex = half_extents_;
    for (int axis = 0; axis < L; ++axis) {
      if (corner >> axis & 1) vertex[axis] = -vertex[axis];
    }
    return vertex;
  }
  VertexId VertexCount() const { return 1U << L; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector<S, L>& direction) const { return direction.cwiseAbs().dot(half_extents_); }

  /// Distance of `point` to the core, metres; 0 inside.
  S Distance(const Vector<S, L>& point) const { return (point.cwiseAbs() - half_extents_).cwiseMax(S(0)).norm(); }

  /// The face whose outward normal is nearest to `direction`.
  void SupportFace(const Vector<S, L>& direction, SupportingFace<S>& face) const requires(L == 3) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    Vector3<S> corner;
    corner[axis] = std::copysign(half_extents_[axis], direction[axis]);
    for (int i = 0; i < 4; ++i) {
      corner[first] = (i == 0 || i == 3) ? half_extents_[first] : -half_extents_[first];
      corner[second] = i < 2 ? half_extents_[second] : -half_extents_[second];
      face.Add(corner);
    }
  }

 private:
  Vector<S, L> half_extents_;
  Vector<S, L> center_ = Vector<S, L>::Zero();
};

/// A rectangle of the plane.
template <class S>
using Rectangle = Box<S, 2>;

}  // namespace dgd
