// Inc, the incremental algorithm for the growth distance of polytopes given by their facets (paper, Sec. I,
// [ong2000fast]), as the paper compares with it. The formulation is the linear program of [ong1996growth],
//
//   min s  subject to  <m, x - p1> <= s for the facets m of set 1, <m, x - p2> <= s for those of set 2,
//
// solved by the primal simplex method, which takes the next active facet from the neighbours of the active ones and
// starts from the active facets of the query before: primal feasible and complementary throughout, done when the dual
// infeasibility vanishes (Tab. I). The published code is closed; what follows is our own way of doing just that.
//
// Divide x - p1 and x - p2 by s: a feasible point is a place across the ray at which both polytopes have points, and
// 1/s is the sum of the heights of these points towards each other. Seen along the ray, the facing sides of the two
// polytopes are two maps, one over the other. The vertices of the program are the vertices of that overlay,
//
//   a vertex of one set over a facet of the other (3 + 1 active facets), two crossing edges (2 + 2),
//
// and its edges are where an edge of one set runs over a facet of the other (2 + 1). A step slides along such an edge,
// the one with the greatest rise before it, until it ends or the facet below does: both are known to the neighbours, so
// a step looks at one vertex's edges or at four ways from a crossing, and at one facet's sides. No step searches all
// facets, nor all vertices. That an edge of the program is an edge of a polytope, not a choice of three facets out of
// those that meet in a vertex, spares the degenerate steps that the textbook's simplex method makes where more than
// three facets meet, as they do in every triangulated hull.
#pragma once

#include <array>
#include <cstdint>

#include "bench/textbook/half_edge_mesh.h"
#include "dgd/query_types.h"

namespace dgd_bench {

/// Where the last query of a pair ended: what lies over what, as seen along the ray.
struct IncrementalState {
  enum class Type : std::uint8_t { kVertex, kEdge, kFacet };
  struct Feature {
    Type type = Type::kFacet;
    int index = 0;  ///< In the set's HalfEdgeMesh.
  };

  /// Of set 1 and of set 2: vertex and facet, edge and edge, facet and vertex; or facet and facet, at the centres,
  /// where these are parallel or at the start.
  std::array<Feature, 2> on;
  bool is_empty = true;
};

/// Growth distance of two polytopes with centres apart. Statuses: kOptimal, kIterationLimit. Needs no tolerance: the
/// last vertex is the exact one up to rounding, so both bounds are one number. Iterations are steps from a feature to a
/// neighbour; no support function is evaluated.
/// @param state  In and out; nullptr for a cold start that remembers nothing.
dgd::Result<double> IncrementalGrowthDistance(const HalfEdgeMesh& mesh_1, const dgd::Pose<double>& pose_1,
                                              const HalfEdgeMesh& mesh_2, const dgd::Pose<double>& pose_2,
                                              IncrementalState* state = nullptr);

}  // namespace dgd_bench
