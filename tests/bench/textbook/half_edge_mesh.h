// A solid polytope by its facets, each of which knows its neighbours: what the incremental algorithm walks on.
#pragma once

#include <vector>

#include "dgd/convex_hull.h"

namespace dgd_bench {

class HalfEdgeMesh {
 public:
  /// A side of a facet, counterclockwise seen from outside. The sides of a facet, and those that leave a vertex, form
  /// rings: `next`, and the one after the `twin`.
  struct HalfEdge {
    int origin = -1;  ///< Vertex.
    int facet = -1;   ///< To the left of it.
    int next = -1;    ///< Half-edge around the facet.
    int twin = -1;    ///< Half-edge of the neighbour, the other way.
  };

  /// Throws std::invalid_argument if the hull is not solid.
  explicit HalfEdgeMesh(const dgd::ConvexHull& hull);

  const Eigen::Vector3d& Center() const { return center_; }  ///< The hull's frame, metres.

  int FacetCount() const { return static_cast<int>(polars_.size()); }

  /// Offset from the centre, metres.
  const Eigen::Vector3d& Vertex(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
  /// The facet lies on the plane <m, x> = 1, x from the centre: m points outwards, 1 / metres.
  const Eigen::Vector3d& Polar(int facet) const { return polars_[static_cast<std::size_t>(facet)]; }

  const HalfEdge& Edge(int edge) const { return edges_[static_cast<std::size_t>(edge)]; }
  const Eigen::Vector3d& Origin(int edge) const { return Vertex(Edge(edge).origin); }
  const Eigen::Vector3d& Target(int edge) const { return Origin(Edge(edge).twin); }

  int EdgeOfFacet(int facet) const { return edge_of_facet_[static_cast<std::size_t>(facet)]; }        ///< Any.
  int EdgeFromVertex(int vertex) const { return edge_of_vertex_[static_cast<std::size_t>(vertex)]; }  ///< Any.
  int NextFromVertex(int edge) const { return Edge(Edge(edge).twin).next; }
  int Neighbor(int edge) const { return Edge(Edge(edge).twin).facet; }

 private:
  Eigen::Vector3d center_;
  std::vector<Eigen::Vector3d> vertices_, polars_;
  std::vector<HalfEdge> edges_;
  std::vector<int> edge_of_facet_, edge_of_vertex_;
};

}  // namespace dgd_bench
