// A facet of the hull of points, found from the points alone: for the first queries of a set whose hull is not built.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "dgd/export.h"
#include "dgd/shapes/vertex_scan.h"
#include "dgd/types.h"

namespace dgd {

/// Places of the facet's vertices in the list of points, counterclockwise seen from outside, the lowest place first.
struct PointFacet {
  /// A facet may have all points of a set that is scanned. Facets of more are thinned.
  static constexpr std::size_t kMaxVertices = kMostScannedVertices;

  std::array<VertexId, kMaxVertices> vertices;
  std::size_t size = 0;

  std::span<const VertexId> Vertices() const { return {vertices.data(), size}; }
};

/// Finds the facet around a support point whose normal is nearest to the direction that it is the support point of; of
/// equals, the one whose vertices come first. Turns a supporting plane about the point, from edge to edge (gift
/// wrapping: Chand and Kapur 1970, "An algorithm for convex polytopes"), which takes some scans of all points for each
/// edge at it.
/// @param points     Metres; their hull is solid, and clearly so.
/// @param scan       The same, by coordinate.
/// @param support    A point of largest <direction, x>.
/// @param direction  Of any length.
/// @return the support point alone if the direction is zero or NaN, or where roundoff hides the facets around it.
/// Does not allocate or throw.
DGD_EXPORT PointFacet FindFacet(std::span<const Eigen::Vector3d> points, const PointArrays<double>& scan,
                                VertexId support, const Eigen::Vector3d& direction);

}  // namespace dgd
