// A segment along the z axis, centred; with a radius, a capsule.
#pragma once

#include <algorithm>

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"

namespace dgd {

template <class S>
class Segment {
 public:
  using Scalar = S;

  /// @param half_length  Metres, >= 0: the end points are (0, 0, +-half_length).
  explicit Segment(S half_length) : half_length_(RequireLength(half_length, true, "segment half length")) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    const VertexId end = direction.z() < 0;
    return {Vertex(end), end};
  }
  Vector3<S> Center() const { return {0, 0, center_z_}; }
  /// See CenteredCore.
  void MoveCenterNear(const Vector3<S>& point) { center_z_ = std::clamp(point.z(), -half_length_, half_length_); }
  S Inradius() const { return 0; }

  Vector3<S> Vertex(VertexId end) const { return {0, 0, end == 0 ? half_length_ : -half_length_}; }
  VertexId VertexCount() const { return 2; }

  /// Distance of `point` to the core, metres; 0 on it.
  S Distance(const Vector3<S>& point) const {
    return (point - Vector3<S>(0, 0, std::clamp(point.z(), -half_length_, half_length_))).norm();
  }

  void SupportFace(const Vector3<S>&, SupportingFace<S>& face) const {
    face.Add(Vertex(0));
    face.Add(Vertex(1));
  }

 private:
  S half_length_;
  S center_z_ = 0;
};

}  // namespace dgd
