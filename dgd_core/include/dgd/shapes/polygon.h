// A convex polygon of the plane, given by its vertices. Makes the hull once, when it is made; immutable after.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/hull_queries.h"

namespace dgd {

template <class S>
class Polygon {
 public:
  using Scalar = S;

  /// @param points  Metres; at least one, all finite, in any order; inner and duplicate points are dropped. Collinear
  ///                or equal ones are allowed and make a segment or a point, of inradius 0. Throws
  ///                std::invalid_argument otherwise.
  explicit Polygon(std::span<const Eigen::Vector2d> points) {
    std::vector<Eigen::Vector3d> lifted;
    lifted.reserve(points.size());
    for (const Eigen::Vector2d& point : points) lifted.emplace_back(point.x(), point.y(), 0);
    const ConvexHull hull = BuildConvexHull(lifted);
    center_ = hull.center.head<2>().template cast<S>();
    TakeCorners(hull);
    inradius_ = FindInradius(hull);
  }

  SupportPoint<S, 2> Support(const Vector2<S>& direction) const {
    VertexId farthest = 0;
    S highest = direction.dot(vertices_[0]);
    for (VertexId vertex = 1; vertex < VertexCount(); ++vertex) {
      const S height = direction.dot(vertices_[vertex]);
      if (!(height > highest)) continue;
      highest = height;
      farthest = vertex;
    }
    return {vertices_[farthest], farthest};
  }
  /// The centroid.
  const Vector2<S>& Center() const { return center_; }
  S Inradius() const { return inradius_; }

  /// Counterclockwise.
  const Vector2<S>& Vertex(VertexId vertex) const { return vertices_[vertex]; }
  VertexId VertexCount() const { return static_cast<VertexId>(vertices_.size()); }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector2<S>& direction) const {
    const Eigen::Vector2d d = direction.template cast<double>();
    double highest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& corner : corners_) highest = std::max(highest, d.dot(corner));
    return static_cast<S>(highest);
  }

  /// Distance of `point` to the core, metres; 0 inside. Looks at every edge: for certificates.
  S Distance(const Vector2<S>& point) const {
    const Eigen::Vector2d x = point.template cast<double>();
    double nearest_sq = std::numeric_limits<double>::infinity();
    bool inside = corners_.size() > 2;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Eigen::Vector2d& start = corners_[i];
      const Eigen::Vector2d edge = corners_[(i + 1) % corners_.size()] - start;
      const Eigen::Vector2d offset = x - start;
      if (Cross(edge, offset) < 0) inside = false;
      const double length_sq = edge.squaredNorm();
      const double along = length_sq > 0 ? std::clamp(edge.dot(offset) / length_sq, 0.0, 1.0) : 0.0;
      nearest_sq = std::min(nearest_sq, (offset - along * edge).squaredNorm());
    }
    return inside ? S(0) : static_cast<S>(std::sqrt(nearest_sq));
  }

 private:
  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

  /// Vertices in the order of the facet that is seen from above.
  void TakeCorners(const ConvexHull& hull) {
    if (hull.dimension < 2) {
      for (const Eigen::Vector3d& vertex : hull.vertices) corners_.push_back(vertex.head<2>());
    } else {
      const std::size_t facet = hull.normals[0].z() > 0 ? 0 : 1;
      for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
        corners_.push_back(hull.vertices[hull.facet_vertices[static_cast<std::size_t>(i)]].head<2>());
      }
    }
    for (const Eigen::Vector2d& corner : corners_) vertices_.push_back(corner.template cast<S>());
  }

  S FindInradius(const ConvexHull& hull) const {
    if (hull.dimension < 2) return 0;
    const Eigen::Vector2d center = hull.center.head<2>();
    double least = std::numeric_limits<double>::infinity();
    double extent = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Eigen::Vector2d edge = corners_[(i + 1) % corners_.size()] - corners_[i];
      extent = std::max(extent, (corners_[i] - center).norm());
      if (edge.norm() > 0) least = std::min(least, Cross(edge, center - corners_[i]) / edge.norm());
    }
    // Roundoff of the hull in double, then of the corners' and the centre's coordinates in S.
    constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();
    constexpr double kVertexRounding = 2 * std::numeric_limits<S>::epsilon();
    return static_cast<S>(std::max(0.0, least - kRounding * extent - kVertexRounding * LargestCoordinate(hull)));
  }

  std::vector<Eigen::Vector2d> corners_;
  std::vector<Vector2<S>> vertices_;
  Vector2<S> center_;
  S inradius_;
};

}  // namespace dgd
