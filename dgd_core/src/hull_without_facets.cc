#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/shapes/hull_queries.h"
#include "dgd/shapes/vertex_scan.h"
#include "hull_facets.h"

namespace dgd {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Least inradius, as a part of the greatest distance from the centre. Sets that are thinner, some 300 times as wide as
/// thick, are Qhull's.
constexpr double kLeastInradius = 1e-3;

/// Metres. Eighth powers are finite, as FindFacet() takes them, and not zero.
constexpr double kLeastExtent = 1e-30, kMostExtent = 1e30;

bool IsSmall(const ConvexHull& hull) { return hull.vertices.size() <= kMostScannedVertices; }

std::vector<Vector3d> WithoutDuplicates(std::span<const Vector3d> points) {
  std::vector<Vector3d> distinct;
  distinct.reserve(points.size());
  for (const Vector3d& point : points) {
    // Most points differ in the first coordinate.
    const auto is_same = [&](const Vector3d& other) { return other.x() == point.x() && other == point; };
    if (std::ranges::none_of(distinct, is_same)) distinct.push_back(point);
  }
  return distinct;
}

/// The facets of a hull of the same points, in the order of their vertices, but thin ones.
/// @return false if roundoff hides one of them.
bool AddFacets(const ConvexHull& built, ConvexHull& hull) {
  std::vector<VertexId> places;
  for (const Vector3d& vertex : built.vertices) {
    const auto place = std::ranges::find(hull.vertices, vertex);
    places.push_back(static_cast<VertexId>(place - hull.vertices.begin()));
  }
  std::set<std::vector<VertexId>> facets;
  for (std::size_t i = 0; i < built.normals.size(); ++i) {
    const VertexId* corners = built.facet_vertices.data() + built.facet_start[i];
    std::array<VertexId, 3> triangle{places[corners[0]], places[corners[1]], places[corners[2]]};
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    if (IsThin(hull.vertices, triangle)) continue;
    const std::optional<PointFacet> facet = FacetOfTriangle(hull.vertices, triangle, triangle[0]);
    if (!facet) return false;
    facets.emplace(facet->Vertices().begin(), facet->Vertices().end());
  }
  for (const std::vector<VertexId>& facet : facets) AddFacet(hull, PolygonNormal(hull.vertices, facet), facet);
  InvertFacets(hull);
  return true;
}

}  // namespace

double InradiusAboutMean(std::span<const Vector3d> points, const Vector3d& mean) {
  Matrix3d covariance = Matrix3d::Zero();
  double extent_sq = 0;
  for (const Vector3d& point : points) {
    const Vector3d offset = point - mean;
    covariance.noalias() += offset * offset.transpose();
    extent_sq = std::max(extent_sq, offset.squaredNorm());
  }
  covariance /= static_cast<double>(points.size());
  const double extent = std::sqrt(extent_sq);
  if (!(extent >= kLeastExtent && extent <= kMostExtent)) return 0;
  // The inverse for thinner sets is roundoff. False for NaN.
  constexpr double kLeastVolume = 1e-12;
  const double size = covariance.trace();
  if (!(covariance.determinant() > kLeastVolume * size * size * size)) return 0;
  const Matrix3d inverse = covariance.inverse();
  double longest_sq = 0;
  for (const Vector3d& point : points) {
    const Vector3d offset = point - mean;
    longest_sq = std::max(longest_sq, offset.dot(inverse * offset));
  }
  // No eigenvalue is above a row's sum.
  const double greatest = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  // Roundoff of the inverse, where the determinant is least, and of the mean.
  constexpr double kRelative = 1e-5, kRounding = 32 * std::numeric_limits<double>::epsilon();
  const double inradius =
      (1 - kRelative) / std::sqrt(longest_sq * greatest) - kRounding * (extent + mean.lpNorm<Eigen::Infinity>());
  return inradius > kLeastInradius * extent ? inradius : 0;
}

std::optional<ConvexHull> HullWithoutFacets(std::span<const Vector3d> points) {
  ConvexHull hull;
  hull.dimension = 3;
  if (points.size() <= kMostScannedVertices) {
    hull.vertices = WithoutDuplicates(points);
  } else {
    hull.vertices.assign(points.begin(), points.end());
  }
  if (hull.vertices.size() < 4) return std::nullopt;
  for (const Vector3d& point : hull.vertices) {
    if (!(point.array().abs() <= kMostCoordinate).all()) return std::nullopt;  // False for NaN.
    hull.center += point;
  }
  hull.center /= static_cast<double>(hull.vertices.size());
  hull.inradius = InradiusAboutMean(hull.vertices, hull.center);
  if (!(hull.inradius > 0 && std::isfinite(hull.inradius))) return std::nullopt;
  // Its facets decide where its centre moves to, from the first query on.
  if (IsSmall(hull) && IsElongated(SpreadOfVertices(hull))) return std::nullopt;
  return hull;
}

ConvexHull WithFacets(const ConvexHull& hull) {
  ConvexHull built = BuildConvexHull(hull.vertices);
  if (IsSmall(hull)) {
    ConvexHull same = hull;
    if (AddFacets(built, same)) return same;
  }
  built.center = hull.center;
  built.inradius = hull.inradius;
  return built;
}

}  // namespace dgd
