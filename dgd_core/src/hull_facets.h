// What makes facets, for what makes hulls.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "dgd/convex_hull.h"
#include "dgd/point_facet.h"

namespace dgd {

/// @param loop  The facet's vertices, counterclockwise seen from outside.
void AddFacet(ConvexHull& hull, const Eigen::Vector3d& normal, std::span<const VertexId> loop);

/// Vertex -> facets, once all facets are there.
void InvertFacets(ConvexHull& hull);

/// Whether a triangle is so thin that roundoff tilts its normal.
bool IsThin(std::span<const Eigen::Vector3d> points, const std::array<VertexId, 3>& triangle);

/// The facet that a triangle of points is a part of: the polygon of all points in its plane.
/// @param points    Metres; their hull is solid, and clearly so.
/// @param triangle  Counterclockwise seen from outside, of a facet, and not thin; the lowest place first.
/// @param kept      A corner of the facet that stays if it is thinned.
/// @return nothing if points are above the triangle's plane, or those in it make no polygon.
std::optional<PointFacet> FacetOfTriangle(std::span<const Eigen::Vector3d> points,
                                          const std::array<VertexId, 3>& triangle, VertexId kept);

/// Outward unit normal of a polygon, by Newell's formula.
/// @param vertices  Three or more, counterclockwise seen from outside. A triangle with the lowest place first has the
///                  same normal to the last bit, regardless of what made it.
Eigen::Vector3d PolygonNormal(std::span<const Eigen::Vector3d> points, std::span<const VertexId> vertices);

}  // namespace dgd
