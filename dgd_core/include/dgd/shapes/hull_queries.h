// What the shapes that are the hull of points have in common: slow and plain queries of the hull, in double.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/convex_hull.h"
#include "dgd/shapes/inner_ball.h"
#include "dgd/shapes/triangle.h"

namespace dgd {

/// Largest coordinate of the hull's vertices; metres.
inline double LargestCoordinate(const ConvexHull& hull) {
  double extent = 0;
  for (const Eigen::Vector3d& vertex : hull.vertices) extent = std::max(extent, vertex.lpNorm<Eigen::Infinity>());
  return extent;
}

/// Radius of the ball about the centre that is inside also when the vertices are rounded to S; metres.
template <class S>
S InradiusOfRounded(const ConvexHull& hull) {
  // Roundoff of the vertices moves a facet by at most their roundoff error.
  constexpr double kVertexRounding = 2 * std::numeric_limits<S>::epsilon();
  return static_cast<S>(std::max(0.0, hull.inradius - kVertexRounding * LargestCoordinate(hull)));
}

/// Matrix about the centre of the ellipsoid whose border has the vertices' moments: theirs times the dimension. Square
/// metres.
inline Eigen::Matrix3d SpreadOfVertices(const ConvexHull& hull) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    const Eigen::Vector3d from_center = vertex - hull.center;
    moments.noalias() += from_center * from_center.transpose();
  }
  return 3 / static_cast<double>(hull.vertices.size()) * moments;
}

/// Whether a hull is so flat or long that a partner near its border must not have it scaled about its centroid: about
/// from a box of 3 x 3 x 1 or 3 x 1 x 1 on. Of random hulls of 8 points on a ball one in sixteen is, of 12 points one
/// in 400.
/// @param spread  SpreadOfVertices().
inline bool IsElongated(const Eigen::Matrix3d& spread) {
  // The eigenvalues' sum times the sum of their inverses: 9 for a cube, 23.2 for both of those boxes.
  constexpr double kRound = 25;
  const Eigen::Matrix3d part = spread / spread.trace();
  const double minors = (1 - part.squaredNorm()) / 2;
  return !(minors < kRound * part.determinant());  // True for points, segments and polygons.
}

/// The planes of a hull's facets, in S, lowered by the roundoff that they and their vertices have. A merged facet is
/// not exactly flat: its innermost vertex bounds the hull from inside.
/// @pre With facets.
template <class S>
std::vector<FacePlane<S>> FacePlanesOf(const ConvexHull& hull) {
  // A hull's inradius is lowered by as much for Qhull's normals and for the vertices, each of them of the extent.
  constexpr double kRounding = 128 * std::numeric_limits<S>::epsilon();
  const double rounding = kRounding * LargestCoordinate(hull);
  std::vector<FacePlane<S>> planes;
  planes.reserve(hull.normals.size());
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    double offset = std::numeric_limits<double>::infinity();
    for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
      const Eigen::Vector3d& vertex = hull.vertices[hull.facet_vertices[static_cast<std::size_t>(i)]];
      offset = std::min(offset, hull.normals[facet].dot(vertex));
    }
    planes.push_back({hull.normals[facet].cast<S>(), static_cast<S>(offset - rounding)});
  }
  return planes;
}

/// Largest <direction, x> over the hull's vertices.
inline double SupportValueOf(const ConvexHull& hull, const Eigen::Vector3d& direction) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : hull.vertices) highest = std::max(highest, direction.dot(vertex));
  return highest;
}

/// Distance of `point` to the hull, metres; 0 inside. Looks at every facet.
inline double DistanceTo(const ConvexHull& hull, const Eigen::Vector3d& point) {
  if (!HasFacets(hull)) return DistanceTo(WithFacets(hull), point);
  if (hull.dimension < 2) {
    const Eigen::Vector3d& end = hull.vertices.back();
    return (ClosestPointOnTriangle<double>(point, hull.vertices.front(), end, end) - point).norm();
  }
  // Outside at least one facet's plane; the nearest point then lies on one of those facets. Flat hulls have none
  // inside. A point of the border is outside of some planes by roundoff alone, and may be on a facet that is in the
  // same plane but for that: so facets count as well whose planes hold the point nearly.
  constexpr double kNearly = 1e-6;
  const double slack =
      hull.dimension == 2 ? std::numeric_limits<double>::infinity() : kNearly * LargestCoordinate(hull);
  double nearest = std::numeric_limits<double>::infinity();
  bool outside = hull.dimension == 2;
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    const auto begin = static_cast<std::size_t>(hull.facet_start[facet]);
    const auto end = static_cast<std::size_t>(hull.facet_start[facet + 1]);
    const Eigen::Vector3d& first = hull.vertices[hull.facet_vertices[begin]];
    const double above = hull.normals[facet].dot(point - first);
    outside |= above > 0;
    if (above <= -slack) continue;
    for (std::size_t i = begin + 1; i + 1 < end; ++i) {
      const Eigen::Vector3d on_facet = ClosestPointOnTriangle<double>(
          point, first, hull.vertices[hull.facet_vertices[i]], hull.vertices[hull.facet_vertices[i + 1]]);
      nearest = std::min(nearest, (on_facet - point).norm());
    }
  }
  return outside ? nearest : 0;
}

/// The place of the facet around `vertex`, the support vertex along d, whose normal is nearest to d; some facet if d is
/// NaN. A point on a facet, which is as high as the facet's corners, has none around it: then of all facets.
/// @pre Of dimension 2 or 3, with facets.
inline std::size_t NearestFacet(const ConvexHull& hull, VertexId vertex, const Eigen::Vector3d& d) {
  DGD_ASSERT(hull.dimension >= 2 && HasFacets(hull) && vertex < hull.vertices.size());
  auto begin = static_cast<std::size_t>(hull.vertex_start[vertex]);
  auto end = static_cast<std::size_t>(hull.vertex_start[vertex + 1]);
  if (begin == end) {
    begin = 0;
    end = hull.vertex_facets.size();
  }
  auto nearest = static_cast<std::size_t>(hull.vertex_facets[begin]);
  double best_alignment = hull.normals[nearest].dot(d);
  for (std::size_t i = begin + 1; i < end; ++i) {
    const auto facet = static_cast<std::size_t>(hull.vertex_facets[i]);
    const double alignment = hull.normals[facet].dot(d);
    if (alignment > best_alignment) {
      best_alignment = alignment;
      nearest = facet;
    }
  }
  return nearest;
}

/// A facet's vertices, thinned from the support vertex on, which stays, if they are too many.
template <class S>
void AddVertices(const ConvexHull& hull, std::span<const VertexId> vertices, VertexId support,
                 SupportingFace<S>& face) {
  const auto add = [&](VertexId vertex) { face.Add(hull.vertices[vertex].template cast<S>()); };
  constexpr std::size_t kMaxPoints = SupportingFace<S>::kMaxPoints;
  if (vertices.size() <= kMaxPoints) {
    for (const VertexId vertex : vertices) add(vertex);
    return;
  }
  const auto first = static_cast<std::size_t>(std::ranges::find(vertices, support) - vertices.begin());
  for (std::size_t i = 0; i < kMaxPoints; ++i) {
    add(vertices[(first + i * vertices.size() / kMaxPoints) % vertices.size()]);
  }
}

/// Adds the facet around `vertex`, the support vertex along `direction`, whose normal is nearest to that, or some facet
/// if the direction is NaN; for hulls below dimension 2 the whole hull.
template <class S>
void AddSupportFace(const ConvexHull& hull, VertexId vertex, const Vector3<S>& direction, SupportingFace<S>& face) {
  if (hull.dimension < 2) {
    for (const Eigen::Vector3d& end : hull.vertices) face.Add(end.template cast<S>());
    return;
  }
  const std::size_t facet = NearestFacet(hull, vertex, direction.template cast<double>());
  const auto begin = static_cast<std::size_t>(hull.facet_start[facet]);
  const std::size_t count = static_cast<std::size_t>(hull.facet_start[facet + 1]) - begin;
  AddVertices(hull, std::span(hull.facet_vertices).subspan(begin, count), vertex, face);
}

}  // namespace dgd
