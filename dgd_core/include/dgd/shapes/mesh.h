// A polytope of many vertices, whose support points are found by walking along its edges. Makes the hull and the edges
// once, when it is made; immutable after, so threads may share it. For few vertices Polytope is faster.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/hull_queries.h"
#include "dgd/supporting_face.h"

namespace dgd {

template <class S>
class Mesh {
 public:
  using Scalar = S;

  /// @param points  Metres; at least one, all finite, in any order; inner and duplicate points are dropped. Flat ones
  ///                are allowed and have inradius 0. Throws std::invalid_argument otherwise.
  explicit Mesh(std::span<const Eigen::Vector3d> points) : Mesh(BuildConvexHull(points)) {}
  explicit Mesh(ConvexHull hull)
      : hull_(std::move(hull)), center_(hull_.center.template cast<S>()), inradius_(InradiusOfRounded<S>(hull_)) {
    for (const Eigen::Vector3d& vertex : hull_.vertices) {
      vertices_.push_back(vertex.template cast<S>());
      offsets_.push_back((vertex - hull_.center).template cast<S>());
      plateau_ = std::max(plateau_, kHeightRounding * offsets_.back().template lpNorm<1>());
    }
    LinkNeighbours();
    ChooseStarts();
  }

  SupportPoint<S> Support(const Vector3<S>& direction) const { return Climb(direction, starts_[StartOf(direction)]); }
  /// Climbs from the vertex `hint`; from where Support() does if there is none of that number.
  SupportPoint<S> Support(const Vector3<S>& direction, FeatureId hint) const {
    return Climb(direction, hint < VertexCount() ? hint : starts_[StartOf(direction)]);
  }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return inradius_; }

  const Vector3<S>& Vertex(VertexId vertex) const { return vertices_[vertex]; }
  VertexId VertexCount() const { return static_cast<VertexId>(vertices_.size()); }

  /// Facets, normals and adjacency, in double whatever S is.
  const ConvexHull& Hull() const { return hull_; }

  /// Largest <direction, x> over the core. Looks at every vertex.
  S SupportValue(const Vector3<S>& direction) const {
    return static_cast<S>(SupportValueOf(hull_, direction.template cast<double>()));
  }

  /// Distance of `point` to the core, metres; 0 inside. Looks at every facet: for certificates.
  S Distance(const Vector3<S>& point) const { return static_cast<S>(DistanceTo(hull_, point.template cast<double>())); }

  /// Of the facets around the support vertex, the one whose normal is nearest to `direction`; for hulls below
  /// dimension 2 the whole hull.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    AddSupportFace(hull_, Support(direction).feature, direction, face);
  }

 private:
  /// With its coordinates about the centre, so that a step of the walk reads one stretch of memory.
  struct Neighbour {
    Vector3<S> offset;
    VertexId vertex;
  };

  /// Heights differ for certain by more than this part of the largest offset.
  static constexpr S kHeightRounding = 4 * std::numeric_limits<S>::epsilon();
  /// Vertices of a plateau that are looked at, at most.
  static constexpr int kMaxPlateau = 32;

  /// Directions of {-1, 0, 1}^3; the middle one stands for none.
  static constexpr std::size_t kStarts = 27;

  static std::size_t StartOf(const Vector3<S>& direction) {
    // Parts below tan(pi / 8) of the largest count as 0.
    const S limit = S(0.41421356) * direction.cwiseAbs().maxCoeff();
    const auto sign = [&](int axis) { return 1 + (direction[axis] > limit) - (direction[axis] < -limit); };
    return static_cast<std::size_t>(9 * sign(0) + 3 * sign(1) + sign(2));
  }

  /// Heights are those above the centre: far from the origin, the others' rounding would hide short edges.
  SupportPoint<S> Climb(const Vector3<S>& direction, VertexId vertex) const {
    if (hull_.dimension < 3) return Scan(direction);
    const S rounding = plateau_ * direction.template lpNorm<Eigen::Infinity>();
    S height = direction.dot(offsets_[vertex]);
    // Heights rise strictly, so this ends; for NaN at once.
    while (Rise(direction, rounding, vertex, height)) {
    }
    return {vertices_[vertex], vertex};
  }

  /// Goes on to a higher vertex, if one is next to this one, or to a vertex that is as high but for rounding: at short
  /// edges, the way up may lead over their other ends.
  bool Rise(const Vector3<S>& direction, S rounding, VertexId& vertex, S& height) const {
    std::array<VertexId, kMaxPlateau> plateau;
    plateau[0] = vertex;
    int size = 1;
    bool rises = false;
    for (int i = 0; i < size && !rises; ++i) {
      const VertexId from = plateau[static_cast<std::size_t>(i)];
      const Neighbour* end = neighbours_.data() + start_[from + 1];
      for (const Neighbour* neighbour = neighbours_.data() + start_[from]; neighbour != end; ++neighbour) {
        const S candidate = direction.dot(neighbour->offset);
        if (candidate > height) {
          height = candidate;
          vertex = neighbour->vertex;
          rises = true;
        } else if (!rises && candidate >= height - rounding && size < kMaxPlateau &&
                   std::find(plateau.begin(), plateau.begin() + size, neighbour->vertex) == plateau.begin() + size) {
          plateau[static_cast<std::size_t>(size++)] = neighbour->vertex;
        }
      }
    }
    return rises;
  }

  /// The vertices of a flat hull are not in one plane but for rounding, and a walk along its edges may miss the one
  /// that sticks out.
  SupportPoint<S> Scan(const Vector3<S>& direction) const {
    VertexId farthest = 0;
    for (VertexId vertex = 1; vertex < VertexCount(); ++vertex) {
      if (direction.dot(offsets_[vertex]) > direction.dot(offsets_[farthest])) farthest = vertex;
    }
    return {vertices_[farthest], farthest};
  }

  /// Joins each vertex to those 1, 2, 4, ... places further around each of its facets. The first are the edges, along
  /// which a walk finds the top of an exact polytope. The others are for merged facets, where many short edges differ
  /// in height by rounding only and could end the walk far from the top; and they cross a large facet in few steps.
  void LinkNeighbours() {
    std::vector<std::vector<VertexId>> links(vertices_.size());
    const auto link = [&](VertexId a, VertexId b) {
      if (a == b) return;
      links[a].push_back(b);
      links[b].push_back(a);
    };
    for (std::size_t facet = 0; facet < hull_.normals.size(); ++facet) {
      const auto begin = static_cast<std::size_t>(hull_.facet_start[facet]);
      const std::size_t count = static_cast<std::size_t>(hull_.facet_start[facet + 1]) - begin;
      for (std::size_t stride = 1; 2 * stride <= count || stride == 1; stride *= 2) {
        for (std::size_t i = 0; i < count; ++i) {
          link(hull_.facet_vertices[begin + i], hull_.facet_vertices[begin + (i + stride) % count]);
        }
      }
    }
    start_.push_back(0);
    for (std::vector<VertexId>& ends : links) {
      std::sort(ends.begin(), ends.end());
      ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
      for (const VertexId end : ends) neighbours_.push_back({offsets_[end], end});
      start_.push_back(neighbours_.size());
    }
  }

  /// By a scan, once.
  void ChooseStarts() {
    for (std::size_t i = 0; i < kStarts; ++i) {
      const Vector3<S> direction(S(i / 9) - 1, S(i / 3 % 3) - 1, S(i % 3) - 1);
      S highest = -std::numeric_limits<S>::infinity();
      for (VertexId vertex = 0; vertex < VertexCount(); ++vertex) {
        const S height = direction.dot(offsets_[vertex]);
        if (!(height > highest)) continue;
        highest = height;
        starts_[i] = vertex;
      }
    }
  }

  ConvexHull hull_;
  std::vector<Vector3<S>> vertices_;
  std::vector<Vector3<S>> offsets_;  // The vertices from the centre.
  S plateau_ = 0;                    // Rounding of the heights, for a direction of unit size; metres.
  std::vector<std::size_t> start_;   // Vertex -> its neighbours, as in ConvexHull.
  std::vector<Neighbour> neighbours_;
  std::array<VertexId, kStarts> starts_{};
  Vector3<S> center_;
  S inradius_;
};

}  // namespace dgd
