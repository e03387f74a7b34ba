// A box, aligned with its frame's axes and centred.
#pragma once

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"

namespace dgd {

template <class S>
class Box {
 public:
  using Scalar = S;

  /// @param half_extents  Metres, each >= 0; a zero makes a rectangle, a segment or a point.
  explicit Box(const Vector3<S>& half_extents) : half_extents_(half_extents) {
    for (int axis = 0; axis < 3; ++axis) RequireLength(half_extents[axis], true, "box half extent");
  }

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    // The sign bit, as copysign() reads it: -0 counts as negative in both.
    const VertexId corner = VertexId(std::signbit(direction.x())) | VertexId(std::signbit(direction.y())) << 1 |
                            VertexId(std::signbit(direction.z())) << 2;
    return {Vector3<S>(std::copysign(half_extents_.x(), direction.x()), std::copysign(half_extents_.y(), direction.y()),
                       std::copysign(half_extents_.z(), direction.z())),
            corner};
  }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return half_extents_.minCoeff(); }
  /// See CenteredCore.
  void MoveCenterNear(const Vector3<S>& point) {
    const Vector3<S> reach = half_extents_.array() - Inradius();
    center_ = point.cwiseMax(-reach).cwiseMin(reach);
  }

  /// Bit i of `corner` is set where coordinate i is negative.
  Vector3<S> Vertex(VertexId corner) const {
    return {corner & 1 ? -half_extents_.x() : half_extents_.x(), corner & 2 ? -half_extents_.y() : half_extents_.y(),
            corner & 4 ? -half_extents_.z() : half_extents_.z()};
  }
  VertexId VertexCount() const { return 8; }

  /// Distance of `point` to the core, metres; 0 inside.
  S Distance(const Vector3<S>& point) const { return (point.cwiseAbs() - half_extents_).cwiseMax(S(0)).norm(); }

  /// The face whose outward normal is nearest to `direction`.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
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
  Vector3<S> half_extents_;
  Vector3<S> center_ = Vector3<S>::Zero();
};

}  // namespace dgd
