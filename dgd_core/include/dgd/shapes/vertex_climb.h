// The vertex of a hull farthest along a direction, by a walk along its edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/shapes/cube_map.h"
#include "dgd/types.h"

namespace dgd {

/// Made once of a solid hull, immutable after.
template <class S>
class VertexClimb {
 public:
  VertexClimb() = default;
  /// @param hull  Of dimension 3: the vertices of a flat hull are not in one plane but for rounding, and a walk along
  ///              its edges may miss the one that sticks out.
  explicit VertexClimb(const ConvexHull& hull) {
    for (const Eigen::Vector3d& vertex : hull.vertices) {
      offsets_.push_back((vertex - hull.center).template cast<S>());
      plateau_ = std::max(plateau_, kHeightRounding * offsets_.back().template lpNorm<1>());
    }
    LinkNeighbours(hull);
    ChooseStarts();
  }

  bool IsEmpty() const { return offsets_.empty(); }

  /// A vertex that is about the farthest. @pre !IsEmpty().
  VertexId Start(const Vector3<S>& direction) const { return starts_[cells_.CellOf(direction)]; }

  /// A vertex of largest <direction, x>, but for rounding; some vertex if the direction is NaN. @pre !IsEmpty().
  /// @param hint  A vertex that is likely to be near; any number will do.
  VertexId Farthest(const Vector3<S>& direction, VertexId hint) const {
    VertexId vertex = hint < offsets_.size() ? hint : Start(direction);
    const S rounding = plateau_ * direction.template lpNorm<Eigen::Infinity>();
    // Heights are those above the centre: far from the origin, the others' rounding would hide short edges.
    S height = direction.dot(offsets_[vertex]);
    // Heights rise strictly, so this ends; for NaN at once.
    while (Rise(direction, rounding, vertex, height)) {
    }
    return vertex;
  }

 private:
  /// With its coordinates about the centre, so that a step of the walk reads one stretch of memory.
  struct Neighbour {
    Vector3<S> offset;
    VertexId vertex;
  };

  /// Heights differ for certain by more than this part of the largest offset.
  static constexpr S kHeightRounding = 4 * std::numeric_limits<S>::epsilon();
  /// Of the table of starts. By measurement, of 241 to 4516 vertices: with 2 and 8, cold queries take 1.06 and 0.97 of
  /// the time.
  static constexpr std::size_t kCellsPerVertex = 4;
  /// Vertices of a plateau that are looked at, at most.
  static constexpr int kMaxPlateau = 32;

  /// Goes on to the highest of the vertices next to this one, if that is higher.
  bool Rise(const Vector3<S>& direction, S rounding, VertexId& vertex, S& height) const {
    const S level = height - rounding;
    bool rises = false, is_plateau = false;
    const Neighbour* end = neighbours_.data() + start_[vertex + 1];
    for (const Neighbour* neighbour = neighbours_.data() + start_[vertex]; neighbour != end; ++neighbour) {
      const S candidate = direction.dot(neighbour->offset);
      is_plateau |= candidate >= level;
      if (candidate > height) {
        height = candidate;
        vertex = neighbour->vertex;
        rises = true;
      }
    }
    return rises || (is_plateau && RiseFromPlateau(direction, rounding, vertex, height));
  }

  /// Goes on to a higher vertex by way of those that are as high as this one but for rounding: at short edges, the way
  /// up may lead over their other ends.
  [[gnu::cold, gnu::noinline]] bool RiseFromPlateau(const Vector3<S>& direction, S rounding, VertexId& vertex,
                                                    S& height) const {
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

  /// Joins each vertex to those 1, 2, 4, ... places further around each of its facets. The first are the edges, along
  /// which a walk finds the top of an exact polytope. The others are for merged facets, where many short edges differ
  /// in height by rounding only and could end the walk far from the top; and they cross a large facet in few steps.
  void LinkNeighbours(const ConvexHull& hull) {
    std::vector<std::vector<VertexId>> links(offsets_.size());
    const auto link = [&](VertexId a, VertexId b) {
      if (a == b) return;
      links[a].push_back(b);
      links[b].push_back(a);
    };
    for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
      const auto begin = static_cast<std::size_t>(hull.facet_start[facet]);
      const std::size_t count = static_cast<std::size_t>(hull.facet_start[facet + 1]) - begin;
      for (std::size_t stride = 1; 2 * stride <= count || stride == 1; stride *= 2) {
        for (std::size_t i = 0; i < count; ++i) {
          link(hull.facet_vertices[begin + i], hull.facet_vertices[begin + (i + stride) % count]);
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

  /// Each by a walk from the start of the cell before.
  void ChooseStarts() {
    cells_ = CubeMap<S>(kCellsPerVertex * offsets_.size());
    VertexId start = 0;
    for (std::size_t cell = 0; cell < cells_.Size(); ++cell) {
      start = Farthest(cells_.MiddleOf(cell), start);
      starts_.push_back(start);
    }
  }

  std::vector<Vector3<S>> offsets_;  // The vertices from the centre.
  S plateau_ = 0;                    // Rounding of the heights, for a direction of unit size; metres.
  std::vector<std::size_t> start_;   // Vertex -> its neighbours, as in ConvexHull.
  std::vector<Neighbour> neighbours_;
  /// For directions of each cell a vertex from which the walk is short.
  CubeMap<S> cells_{0};
  std::vector<VertexId> starts_;
};

}  // namespace dgd
