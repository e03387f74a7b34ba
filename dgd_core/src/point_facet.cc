#include "dgd/point_facet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "dgd/assert.h"
#include "dgd/convex_hull.h"
#include "hull_facets.h"

namespace dgd {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<VertexId, 3>;

template <class Vertices>
void PutLowestFirst(Vertices&& vertices) {
  std::rotate(vertices.begin(), std::ranges::min_element(vertices), vertices.end());
}

bool Holds(std::span<const VertexId> vertices, VertexId vertex) {
  return std::ranges::find(vertices, vertex) != vertices.end();
}

/// What roundoff may turn a triangle's normal by, squared; rad.
double TiltSq(std::span<const Vector3d> points, const Triangle& triangle) {
  constexpr double kRoundoff = 32 * std::numeric_limits<double>::epsilon();
  const Vector3d side_1 = points[triangle[1]] - points[triangle[0]], side_2 = points[triangle[2]] - points[triangle[0]];
  const double longest_sq = std::max({side_1.squaredNorm(), side_2.squaredNorm(), (side_2 - side_1).squaredNorm()});
  return kRoundoff * longest_sq * (kRoundoff * longest_sq) / side_1.cross(side_2).squaredNorm();
}

/// The facets around a support point. Where more than three points are in a plane, each triangle that the plane is
/// turned through counts as a facet; but thin ones, whose neighbours hold their edges, do not.
class FacetsAround {
 public:
  FacetsAround(std::span<const Vector3d> points, const PointArrays<double>& scan, VertexId support,
               const Vector3d& direction)
      : points_(points), scan_(scan), support_(support), direction_(direction) {}

  /// A triangle of the facet whose normal is nearest to the direction; nothing where roundoff leaves no triangle.
  std::optional<Triangle> FindNearest() const {
    Vector3d normal = direction_;
    // The supporting plane turns to where an edge is about any axis.
    std::optional<VertexId> edge = TurnAbout(normal.unitOrthogonal(), normal);
    std::optional<Triangle> nearest;
    double best_alignment = -std::numeric_limits<double>::infinity();
    const double roundoff = kFlatness * direction_.norm();
    // A support point with more edges is the tip of a cone, whose facets are alike.
    PointFacet edges;
    while (edge && edges.size < PointFacet::kMaxVertices && !Holds(edges.Vertices(), *edge)) {
      DGD_ASSERT(*edge < points_.size());
      edges.vertices[edges.size++] = *edge;
      const std::optional<VertexId> next = TurnAbout(points_[*edge] - points_[support_], normal);
      if (!next) break;
      Triangle triangle{support_, *edge, *next};
      PutLowestFirst(triangle);
      edge = next;
      if (IsThin(points_, triangle)) continue;
      const double alignment = PolygonNormal(points_, triangle).dot(direction_);
      const bool is_tied = std::abs(alignment - best_alignment) <= roundoff;
      if (is_tied ? ComesBefore(triangle, *nearest) : alignment > best_alignment) {
        best_alignment = alignment;
        nearest = triangle;
      }
    }
    return nearest;
  }

 private:
  /// Whether the facet of triangle `a` comes before that of `b`, where the triangles' normals are equally near but for
  /// roundoff.
  bool ComesBefore(const Triangle& a, const Triangle& b) const {
    const std::optional<PointFacet> facet_a = FacetOfTriangle(points_, a, support_);
    const std::optional<PointFacet> facet_b = FacetOfTriangle(points_, b, support_);
    if (!facet_a || !facet_b) return facet_a.has_value();
    const double alignment_a = PolygonNormal(points_, facet_a->Vertices()).dot(direction_);
    const double alignment_b = PolygonNormal(points_, facet_b->Vertices()).dot(direction_);
    if (alignment_a != alignment_b) return alignment_a > alignment_b;
    return std::ranges::lexicographical_compare(facet_a->Vertices(), facet_b->Vertices());
  }

  /// What a supporting plane through the support point meets first when it is turned about an axis in it, over to the
  /// axis's left seen from outside. Turned too far at first, it goes back to the point that is highest above it, until
  /// none is.
  /// @param axis    Of any length.
  /// @param normal  Of the plane, outward, of any length; about at right angles to the axis. Out: as it is turned.
  std::optional<VertexId> TurnAbout(const Vector3d& axis, Vector3d& normal) const {
    constexpr double kRoundoff = 16 * std::numeric_limits<double>::epsilon();
    constexpr int kMostTurns = 64;
    const Vector3d upside_down = -normal;
    normal = normal.cross(axis);
    // Part of the lengths that the normal is the product of: roundoff is a part of these, also where they are nearly
    // parallel.
    double scale_sq = normal.squaredNorm();
    std::optional<VertexId> met;
    for (int i = 0; i < kMostTurns; ++i) {
      const VertexId highest = scan_.Farthest(normal);
      const Vector3d offset = points_[highest] - points_[support_];
      const double height = normal.dot(offset);
      const double reach_sq = points_[highest].squaredNorm() + points_[support_].squaredNorm();
      if (height > 0 && height * height > kRoundoff * kRoundoff * scale_sq * reach_sq) {
        met = highest;
        normal = axis.cross(offset);
        scale_sq = axis.squaredNorm() * offset.squaredNorm();
      } else if (met || normal == upside_down) {
        break;
      } else {
        normal = upside_down;  // It turns by more than a right angle, then.
        scale_sq = normal.squaredNorm();
      }
    }
    return met;
  }

  std::span<const Vector3d> points_;
  const PointArrays<double>& scan_;
  VertexId support_;
  const Vector3d& direction_;
};

/// The polygon of the points in a supporting plane.
class PlanarPolygon {
 public:
  PlanarPolygon(std::span<const Vector3d> points, const Triangle& triangle)
      : points_(points), normal_(PolygonNormal(points, triangle)), origin_(points[triangle[0]]) {
    double reach_sq = 0, highest = 0;
    for (const Vector3d& point : points) {
      reach_sq = std::max(reach_sq, (point - origin_).squaredNorm());
      highest = std::max(highest, normal_.dot(point - origin_));
    }
    tolerance_ = kFlatness * std::sqrt(reach_sq);
    is_supporting_ = highest <= std::max(tolerance_, std::sqrt(TiltSq(points, triangle) * reach_sq));
  }

  bool IsSupporting() const { return is_supporting_; }

  /// Whether a polygon in the plane that has this normal is one.
  bool IsAcross(const Vector3d& normal) const { return normal.dot(normal_) > 0.5; }

  /// Whether the point is in the plane.
  bool Contains(VertexId i) const { return std::abs(normal_.dot(points_[i] - origin_)) <= tolerance_; }

  /// The hull of points in the plane, all of which are in `members` (Jarvis's march).
  void March(std::span<const VertexId> members, PointFacet& facet) const {
    const auto away_sq = [&](VertexId i) { return (points_[i] - points_[members[0]]).squaredNorm(); };
    const VertexId first = std::ranges::max(members, {}, away_sq);
    std::optional<VertexId> corner = first;
    // Roundoff may keep the march from coming back to where it began.
    while (corner && facet.size < members.size()) {
      facet.vertices[facet.size++] = *corner;
      std::optional<VertexId> next;
      for (const VertexId i : members) {
        if (!AreOne(*corner, i) && (!next || IsFartherRight(*corner, *next, i))) next = i;
      }
      corner = next && !AreOne(*next, first) ? next : std::nullopt;
    }
  }

  /// The farthest points of the plane along directions all around.
  /// @param kept  Takes the place of the one that is nearest to it.
  void Sample(VertexId kept, PointFacet& facet) const {
    constexpr int kDirections = 16;
    const Vector3d x = normal_.unitOrthogonal(), y = normal_.cross(x);
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * std::numbers::pi * k / kDirections;
      const VertexId farthest = Farthest(std::cos(angle) * x + std::sin(angle) * y);
      const auto is_same = [&](VertexId i) { return AreOne(i, farthest); };
      if (std::ranges::none_of(facet.Vertices(), is_same)) facet.vertices[facet.size++] = farthest;
    }
    DGD_ASSERT(facet.size > 0 && facet.size <= facet.vertices.size());
    const auto away_sq = [&](VertexId i) { return (points_[i] - points_[kept]).squaredNorm(); };
    *std::ranges::min_element(facet.vertices.begin(), facet.vertices.begin() + facet.size, {}, away_sq) = kept;
  }

 private:
  /// Whether two points are in one place, but for roundoff.
  bool AreOne(VertexId i, VertexId j) const {
    return (points_[i] - points_[j]).squaredNorm() <= tolerance_ * tolerance_;
  }

  /// Whether point i is to the right of the way from a corner to the next one, or on it and farther away: points on an
  /// edge, but for roundoff, are no corners.
  bool IsFartherRight(VertexId corner, VertexId next, VertexId i) const {
    const Vector3d way = points_[next] - points_[corner], offset = points_[i] - points_[corner];
    const double side = normal_.dot(way.cross(offset)), on_way = tolerance_ * way.norm();
    return side < -on_way || (side <= on_way && offset.squaredNorm() > way.squaredNorm());
  }

  VertexId Farthest(const Vector3d& direction) const {
    VertexId farthest = 0;
    double highest = -std::numeric_limits<double>::infinity();
    for (VertexId i = 0; i < points_.size(); ++i) {
      const double height = direction.dot(points_[i]);
      if (!(height > highest && Contains(i))) continue;
      farthest = i;
      highest = height;
    }
    return farthest;
  }

  std::span<const Vector3d> points_;
  Vector3d normal_, origin_;
  double tolerance_;
  bool is_supporting_;
};

}  // namespace

bool IsThin(std::span<const Vector3d> points, const std::array<VertexId, 3>& triangle) {
  // Metres that a point a metre away is off by: a tenth of float's roundoff.
  constexpr double kMostTilt = 1e-8;
  return !(TiltSq(points, triangle) <= kMostTilt * kMostTilt);  // True also where it has no area.
}

Vector3d PolygonNormal(std::span<const Vector3d> points, std::span<const VertexId> vertices) {
  const Vector3d& first = points[vertices[0]];
  Vector3d area = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    area += (points[vertices[i]] - first).cross(points[vertices[i + 1]] - first);
  }
  return area.normalized();
}

std::optional<PointFacet> FacetOfTriangle(std::span<const Vector3d> points, const std::array<VertexId, 3>& triangle,
                                          VertexId kept) {
  const PlanarPolygon polygon(points, triangle);
  if (!polygon.IsSupporting()) return std::nullopt;
  std::array<VertexId, PointFacet::kMaxVertices> members{};
  std::size_t count = 0;
  for (VertexId i = 0; i < points.size() && count <= members.size(); ++i) {
    // A thin triangle's own corners are off its plane by more than the tolerance.
    if (!polygon.Contains(i) && !Holds(triangle, i)) continue;
    if (count < members.size()) members[count] = i;
    ++count;
  }
  PointFacet facet;
  if (count == triangle.size()) {
    std::ranges::copy(triangle, facet.vertices.begin());
    facet.size = count;
  } else if (count <= members.size()) {
    polygon.March({members.data(), count}, facet);
  } else {
    polygon.Sample(kept, facet);
  }
  // Points that are one but for roundoff may make no polygon.
  if (!polygon.IsAcross(PolygonNormal(points, facet.Vertices()))) return std::nullopt;
  PutLowestFirst(std::span(facet.vertices.data(), facet.size));
  return facet;
}

PointFacet FindFacet(std::span<const Vector3d> points, const PointArrays<double>& scan, VertexId support,
                     const Vector3d& direction) {
  DGD_ASSERT(support < points.size() && points.size() == scan.size());
  std::optional<PointFacet> facet;
  // False for NaN.
  if (direction.squaredNorm() > 0) {
    const std::optional<Triangle> triangle = FacetsAround(points, scan, support, direction).FindNearest();
    if (triangle) facet = FacetOfTriangle(points, *triangle, support);
  }
  if (facet) return *facet;
  PointFacet alone;
  alone.vertices[alone.size++] = support;
  return alone;
}

}  // namespace dgd
