// The vertex of a hull farthest along a direction, by a climb along its edges (hill climbing).
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "dgd/assert.h"
#include "dgd/convex_hull.h"
#include "dgd/inlining.h"
#include "dgd/shapes/cube_map.h"
#include "dgd/types.h"

namespace dgd {

/// Made once of a solid hull, immutable after.
template <class S>
class VertexClimb {
 public:
  VertexClimb() = default;
  /// @param hull  Of dimension 3: the vertices of a flat hull are not in one plane but for roundoff, and a climb along
  ///              its edges may miss the one that sticks out.
  explicit VertexClimb(const ConvexHull& hull) {
    for (const Eigen::Vector3d& vertex : hull.vertices) {
      offsets_.push_back((vertex - hull.center).template cast<S>());
      roundoff_ = std::max(roundoff_, kHeightRounding * offsets_.back().template lpNorm<1>());
    }
    LinkNeighbours(hull);
    FindPlateaus(hull);
    ChooseStarts();
  }

  bool IsEmpty() const { return offsets_.empty(); }

  /// A vertex that is about the farthest. @pre !IsEmpty().
  VertexId Start(const Vector3<S>& direction) const {
    DGD_ASSERT(!IsEmpty());
    return starts_[cells_.CellOf(direction)];
  }

  /// A vertex of largest <direction, x>, but for roundoff; some vertex if the direction is NaN. @pre !IsEmpty().
  /// @param hint  A vertex that is likely to be near; any number will do.
  VertexId Farthest(const Vector3<S>& direction, VertexId hint) const {
    DGD_ASSERT(!IsEmpty());
    VertexId vertex = hint < offsets_.size() ? hint : Start(direction);
    const S size = direction.template lpNorm<Eigen::Infinity>();
    // Heights are those above the centre: far from the origin, the others' roundoff would hide short edges.
    S height = direction.dot(offsets_[vertex]);
    // Heights rise strictly, so this ends; for NaN at once.
    while (Rise(direction, size, vertex, height)) {
    }
    return vertex;
  }

  /// See LinkedCore. @pre !IsEmpty(), and a vertex.
  EdgeSlope<S> SteepestAscent(VertexId vertex, const Vector3<S>& up, const Vector3<S>& outwards) const {
    // The edge itself that a plane turns about leads outwards by roundoff only, and its slope is any number.
    constexpr S kLeastSq = S(16) * std::numeric_limits<S>::epsilon();
    DGD_ASSERT(vertex < links_.size());
    const S least_sq = kLeastSq * outwards.squaredNorm();
    EdgeSlope<S> steepest{vertex, -std::numeric_limits<S>::infinity()};
    const Links& links = links_[vertex];
    for (std::uint32_t i = links.begin; i < links.end; ++i) {
      const Neighbour& neighbour = neighbours_[i];
      const Vector3<S> way = neighbour.offset - offsets_[vertex];
      const S out = outwards.dot(way), rise = up.dot(way);
      if (!(out > 0 && rise > steepest.slope * out && out * out > least_sq * way.squaredNorm())) continue;
      steepest = {neighbour.vertex, rise / out};
    }
    return steepest;
  }

 private:
  /// A neighbour with its coordinates about the centre, so that a step of the climb reads one stretch of memory.
  struct Neighbour {
    Vector3<S> offset;
    VertexId vertex;
  };

  /// The list of a vertex's neighbours.
  struct Links {
    std::uint32_t begin, end;
    /// Neighbours that are lower by no more than this times the direction's size may lead upwards; below 0 if none may.
    S plateau;
  };

  /// Heights differ for certain by more than this part of the largest offset.
  static constexpr S kHeightRounding = 4 * std::numeric_limits<S>::epsilon();
  /// A rise that need not be found, as a part of the largest offset: a thousandth of what the tests allow witness
  /// points to be off by. It is below float's roundoff: in float, all plateaus are searched.
  static constexpr S kInvisible = S(1e-12);
  /// Cells of the table of starts. With 2 and 8, cold queries of hulls of 241 to 4516 vertices take 1.06 and 0.97 of
  /// the time.
  static constexpr std::size_t kCellsPerVertex = 4;
  /// Most vertices of a plateau that are searched.
  static constexpr int kMaxPlateau = 32;

  /// Goes on to the highest of the vertices next to this one, if that is higher.
  /// @param size  The direction's largest coordinate.
  bool Rise(const Vector3<S>& direction, S size, VertexId& vertex, S& height) const {
    const Links& links = links_[vertex];
    const S level = height - links.plateau * size;
    bool rises = false, is_plateau = false;
    for (std::uint32_t i = links.begin; i < links.end; ++i) {
      const Neighbour& neighbour = neighbours_[i];
      const S candidate = direction.dot(neighbour.offset);
      is_plateau |= candidate >= level;
      if (candidate > height) {
        height = candidate;
        vertex = neighbour.vertex;
        rises = true;
      }
    }
    return rises || (is_plateau && RiseFromPlateau(direction, size, vertex, height));
  }

  /// Goes on to a higher vertex by way of those that are as high as this one but for roundoff: at short edges, the way
  /// up may lead over their other ends.
  DGD_COLD bool RiseFromPlateau(const Vector3<S>& direction, S size, VertexId& vertex, S& height) const {
    std::array<VertexId, kMaxPlateau> plateau;
    plateau[0] = vertex;
    int count = 1;
    bool rises = false;
    for (int i = 0; i < count && !rises; ++i) {
      const Links& links = links_[plateau[static_cast<std::size_t>(i)]];
      for (std::uint32_t j = links.begin; j < links.end; ++j) {
        const Neighbour& neighbour = neighbours_[j];
        const S candidate = direction.dot(neighbour.offset);
        if (candidate > height) {
          height = candidate;
          vertex = neighbour.vertex;
          rises = true;
        } else if (!rises && candidate >= height - roundoff_ * size && count < kMaxPlateau &&
                   std::find(plateau.begin(), plateau.begin() + count, neighbour.vertex) == plateau.begin() + count) {
          plateau[static_cast<std::size_t>(count++)] = neighbour.vertex;
        }
      }
    }
    return rises;
  }

  /// Joins each vertex to those 1, 2, 4, ... places further around each of its facets. The first are the edges, along
  /// which a climb finds the top of an exact polytope. The others are for merged facets, where many short edges differ
  /// in height by roundoff only and could end the climb far from the top; and they cross a large facet in few steps.
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
    for (std::vector<VertexId>& ends : links) {
      std::sort(ends.begin(), ends.end());
      ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
      const auto begin = static_cast<std::uint32_t>(neighbours_.size());
      for (const VertexId end : ends) neighbours_.push_back({offsets_[end], end});
      links_.push_back({begin, static_cast<std::uint32_t>(neighbours_.size()), 0});
    }
  }

  /// A vertex that no neighbour is higher than, but for roundoff, is the highest along a direction that is tilted by
  /// that roundoff over an edge's length, and by more where its edges are nearly parallel. So what is higher is so by
  /// that angle times the hull's size at most: only short edges and thin corners make a rise of it. Where a query ends
  /// there is a plateau, the facet's corners: if all of them were searched, warm queries of hulls of 241 and 2000
  /// vertices take 1.5 times as long.
  void FindPlateaus(const ConvexHull& hull) {
    const S least = 2 * roundoff_ / kInvisible;
    for (Links& links : links_) links.plateau = -roundoff_;
    for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
      const auto begin = static_cast<std::size_t>(hull.facet_start[facet]);
      const std::size_t count = static_cast<std::size_t>(hull.facet_start[facet + 1]) - begin;
      const auto corner = [&](std::size_t i) { return hull.facet_vertices[begin + i % count]; };
      for (std::size_t i = 0; i < count; ++i) {
        const VertexId vertex = corner(i + 1);
        const Vector3<S> back = offsets_[corner(i)] - offsets_[vertex], on = offsets_[corner(i + 2)] - offsets_[vertex];
        const S longer = std::sqrt(std::max(back.squaredNorm(), on.squaredNorm()));
        if (!(back.cross(on).norm() > least * longer)) links_[vertex].plateau = roundoff_;
      }
    }
  }

  /// Finds each start by a climb from that of the cell before.
  void ChooseStarts() {
    cells_ = CubeMap<S>(kCellsPerVertex * offsets_.size());
    VertexId start = 0;
    for (std::size_t cell = 0; cell < cells_.Size(); ++cell) {
      start = Farthest(cells_.MiddleOf(cell), start);
      starts_.push_back(start);
    }
  }

  std::vector<Vector3<S>> offsets_;  // The vertices from the centre.
  S roundoff_ = 0;                   // Roundoff of the heights, for a direction of unit size; metres.
  std::vector<Links> links_;         // Links of each vertex.
  std::vector<Neighbour> neighbours_;
  /// A vertex for the directions of each cell, from which the climb is short.
  CubeMap<S> cells_{0};
  std::vector<VertexId> starts_;
};

}  // namespace dgd
