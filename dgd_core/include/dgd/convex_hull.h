// Convex hulls of point sets by Qhull, with the adjacency that support functions and contact patches need.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "dgd/export.h"
#include "dgd/types.h"

namespace dgd {

/// The hull of a point set, in the points' frame. Lists of lists are stored as one array with the start of each list
/// and a closing end: list i is [start[i], start[i + 1]).
struct ConvexHull {
  int dimension = 0;                      ///< 3: solid. 2: flat, two facets back to back. 1: segment. 0: point.
  std::vector<Eigen::Vector3d> vertices;  ///< Extreme points only, but for HullWithoutFacets(); metres.
  std::vector<Eigen::Vector3d> normals;   ///< Outward unit normal of each facet; empty below dimension 2.
  std::vector<int> facet_start;           ///< Facet -> its vertices ...
  std::vector<VertexId> facet_vertices;   ///< ... counterclockwise seen from outside; coplanar triangles are merged.
  std::vector<int> vertex_start;          ///< Vertex -> the facets around it ...
  std::vector<int> vertex_facets;         ///< ... in no order.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Centroid; of points without facets, their mean.
  double inradius = 0;  ///< Safe lower bound on the radius of the ball about the centre; 0 below dimension 3, metres.
};

/// Points nearer to a common plane (line, point) than this part of the set's extent make a flat hull: thinner sets are
/// below what Qhull separates from roundoff, with a decade to spare. Test: ConvexHull_NearlyFlat_*.
inline constexpr double kFlatness = 1e-12;

/// Coordinates reach no farther: fourth powers, as a centroid's moments are, stay finite. Metres.
inline constexpr double kMostCoordinate = 1e75;

/// @param points  Metres, in any order, duplicates and interior points allowed; at least one, all within
///                kMostCoordinate of the origin along each axis.
/// Throws std::invalid_argument if there are none or one is not finite or farther away, naming its index; or if Qhull
/// finds no hull of points that are clearly not flat, saying why. Flat input is not an error: it has a lower dimension.
DGD_EXPORT ConvexHull BuildConvexHull(std::span<const Eigen::Vector3d> points);

/// Points as a hull that has no facets yet: what support functions need, in a hundredth of the time. Its vertices are
/// the points in their order, interior ones among them; of few points, duplicates are dropped. Its centre is their
/// mean.
/// @return nothing for points that are flat, or thin, or fewer than four, or not all within kMostCoordinate:
///         these are BuildConvexHull()'s. Nothing either for up to kMostScannedVertices points that are flat or
///         long as IsElongated() has it: the facets of such a hull are needed from the first query on.
DGD_EXPORT std::optional<ConvexHull> HullWithoutFacets(std::span<const Eigen::Vector3d> points);

/// Radius of a ball about the points' mean that is inside their hull; metres, 0 or NaN if there is none for certain.
///
/// Let C be the covariance of the points, and r the greatest length of C^-1/2 (x - mean). Along any direction, the
/// points so whitened have mean 0, variance 1, and none is below -r: so one is at 1/r or above (Bhatia and Davis, "A
/// better bound on the variance", 2000). That is, the hull holds the ball of 1/r there, and here the ellipsoid that it
/// was, whose least half axis is 1/r times the root of C's least eigenvalue.
DGD_EXPORT double InradiusAboutMean(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& mean);

inline bool HasFacets(const ConvexHull& hull) { return hull.dimension < 3 || !hull.normals.empty(); }

/// The same with its facets, about the same centre. Of up to kMostScannedVertices points it has the same vertices, and
/// the facets that FindFacet() finds: queries of the two agree to the last bit, unless points are so near to an edge
/// that roundoff decides which of its triangles are facets.
/// @param hull  From HullWithoutFacets(). Throws as BuildConvexHull().
DGD_EXPORT ConvexHull WithFacets(const ConvexHull& hull);

}  // namespace dgd
