// A polytope given by its vertices. Makes the hull once, when it is made; immutable after, so threads may share it.
#pragma once

#include <span>
#include <utility>

#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/hull_queries.h"
#include "dgd/shapes/vertex_scan.h"
#include "dgd/supporting_face.h"

namespace dgd {

template <class S>
class Polytope {
 public:
  using Scalar = S;

  /// @param points  Metres; at least one, all finite, in any order; inner and duplicate points are dropped. Flat ones
  ///                are allowed and have inradius 0. Throws std::invalid_argument otherwise.
  explicit Polytope(std::span<const Eigen::Vector3d> points) : Polytope(BuildConvexHull(points)) {}
  explicit Polytope(ConvexHull hull)
      : hull_(std::move(hull)),
        vertices_(hull_.vertices),
        center_(hull_.center.template cast<S>()),
        inradius_(InradiusOfRounded<S>(hull_)) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    const VertexId vertex = vertices_.Farthest(direction);
    return {vertices_[vertex], vertex};
  }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return inradius_; }

  Vector3<S> Vertex(VertexId vertex) const { return vertices_[vertex]; }
  VertexId VertexCount() const { return static_cast<VertexId>(vertices_.size()); }

  /// Facets, normals and adjacency, in double whatever S is.
  const ConvexHull& Hull() const { return hull_; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    return static_cast<S>(SupportValueOf(hull_, direction.template cast<double>()));
  }

  /// Distance of `point` to the core, metres; 0 inside. Looks at every facet: for certificates.
  S Distance(const Vector3<S>& point) const { return static_cast<S>(DistanceTo(hull_, point.template cast<double>())); }

  /// Of the facets around the support vertex, the one whose normal is nearest to `direction`; for hulls below
  /// dimension 2 the whole hull.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    AddSupportFace(hull_, vertices_.Farthest(direction), direction, face);
  }

 private:
  ConvexHull hull_;
  PointArrays<S> vertices_;
  Vector3<S> center_;
  S inradius_;
};

}  // namespace dgd
