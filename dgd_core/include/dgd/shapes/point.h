// A point; with a radius, a sphere.
#pragma once

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"

namespace dgd {

/// The origin of its own frame.
template <class S>
class Point {
 public:
  using Scalar = S;

  SupportPoint<S> Support(const Vector3<S>&) const { return {Vector3<S>::Zero(), 0}; }
  Vector3<S> Center() const { return Vector3<S>::Zero(); }
  S Inradius() const { return 0; }

  Vector3<S> Vertex(VertexId) const { return Vector3<S>::Zero(); }
  VertexId VertexCount() const { return 1; }

  /// Distance of `point` to the core, metres; 0 inside.
  S Distance(const Vector3<S>& point) const { return point.norm(); }

  void SupportFace(const Vector3<S>&, SupportingFace<S>& face) const { face.Add(Vector3<S>::Zero()); }
};

}  // namespace dgd
