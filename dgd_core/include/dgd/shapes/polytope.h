// A polytope given by its vertices. Makes the hull once, when it is made; immutable after, so threads may share it.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/triangle.h"
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
        // Rounding of the vertices to S moves a facet by at most their rounding error.
        inradius_(static_cast<S>(std::max(0.0, hull_.inradius - kVertexRounding * Extent()))) {}

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

  /// Distance of `point` to the core, metres; 0 inside. Looks at every facet: for certificates.
  S Distance(const Vector3<S>& point) const;

  /// Of the facets around the support vertex, the one whose normal is nearest to `direction`; for hulls below
  /// dimension 2 the whole hull.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const;

 private:
  static constexpr double kVertexRounding = 2 * std::numeric_limits<S>::epsilon();

  double Extent() const {
    double extent = 0;
    for (const Eigen::Vector3d& vertex : hull_.vertices) extent = std::max(extent, vertex.lpNorm<Eigen::Infinity>());
    return extent;
  }

  ConvexHull hull_;
  PointArrays<S> vertices_;
  Vector3<S> center_;
  S inradius_;
};

template <class S>
S Polytope<S>::Distance(const Vector3<S>& point) const {
  const Eigen::Vector3d x = point.template cast<double>();
  if (hull_.dimension < 2) {
    const Eigen::Vector3d& end = hull_.vertices.back();
    return static_cast<S>((ClosestPointOnTriangle<double>(x, hull_.vertices.front(), end, end) - x).norm());
  }
  // Outside at least one facet's plane; the nearest point then lies on one of those facets. Flat hulls have none
  // inside.
  double nearest = hull_.dimension == 2 ? std::numeric_limits<double>::infinity() : 0;
  bool outside = hull_.dimension == 2;
  for (std::size_t facet = 0; facet < hull_.normals.size(); ++facet) {
    const auto begin = static_cast<std::size_t>(hull_.facet_start[facet]);
    const auto end = static_cast<std::size_t>(hull_.facet_start[facet + 1]);
    const Eigen::Vector3d& first = hull_.vertices[hull_.facet_vertices[begin]];
    if (hull_.dimension == 3 && hull_.normals[facet].dot(x - first) <= 0) continue;
    if (!outside) nearest = std::numeric_limits<double>::infinity();
    outside = true;
    for (std::size_t i = begin + 1; i + 1 < end; ++i) {
      const Eigen::Vector3d on_facet = ClosestPointOnTriangle<double>(x, first, hull_.vertices[hull_.facet_vertices[i]],
                                                                      hull_.vertices[hull_.facet_vertices[i + 1]]);
      nearest = std::min(nearest, (on_facet - x).norm());
    }
  }
  return static_cast<S>(nearest);
}

template <class S>
void Polytope<S>::SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
  if (hull_.dimension < 2) {
    for (const Eigen::Vector3d& vertex : hull_.vertices) face.Add(vertex.template cast<S>());
    return;
  }
  const Eigen::Vector3d d = direction.template cast<double>();
  const VertexId vertex = vertices_.Farthest(direction);
  int best_facet = -1;
  double best_alignment = -std::numeric_limits<double>::infinity();
  for (int i = hull_.vertex_start[vertex]; i < hull_.vertex_start[vertex + 1]; ++i) {
    const int facet = hull_.vertex_facets[static_cast<std::size_t>(i)];
    const double alignment = hull_.normals[static_cast<std::size_t>(facet)].dot(d);
    if (alignment > best_alignment) {
      best_alignment = alignment;
      best_facet = facet;
    }
  }
  const int begin = hull_.facet_start[static_cast<std::size_t>(best_facet)];
  const int count = hull_.facet_start[static_cast<std::size_t>(best_facet) + 1] - begin;
  const VertexId* facet_vertices = hull_.facet_vertices.data() + begin;
  constexpr int kMaxPoints = SupportingFace<S>::kMaxPoints;
  if (count <= kMaxPoints) {
    for (int i = 0; i < count; ++i) face.Add(vertices_[facet_vertices[i]]);
    return;
  }
  // Thinned from the support vertex on, which stays.
  int first = 0;
  while (facet_vertices[first] != vertex) ++first;
  for (int i = 0; i < kMaxPoints; ++i) face.Add(vertices_[facet_vertices[(first + i * count / kMaxPoints) % count]]);
}

}  // namespace dgd
