// A point; with a radius, a sphere or a circle.
#pragma once

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"

namespace dgd {

/// The origin of its own frame.
template <class S, int L = 3>
class Point {
 public:
  using Scalar = S;

  SupportPoint<S, L> Support(const Vector<S, L>&) const { return {Vector<S, L>::Zero(), 0}; }
  Vector<S, L> Center() const { return Vector<S, L>::Zero(); }
  S Inradius() const { return 0; }

  Vector<S, L> Vertex(VertexId) const { return Vector<S, L>::Zero(); }
  VertexId VertexCount() const { return 1; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector<S, L>&) const { return 0; }

  /// Distance of `point` to the core, metres; 0 inside.
  S Distance(const Vector<S, L>& point) const { return point.norm(); }

  void SupportFace(const Vector<S, L>&, SupportingFace<S>& face) const requires(L == 3) {
    face.Add(Vector<S, L>::Zero());
  }
};

}  // namespace dgd
