#include "dgd/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

#include "hull_facets.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace dgd {
namespace {

using Eigen::Vector3d;

void RequireFinitePoints(std::span<const Vector3d> points) {
  if (points.empty()) throw std::invalid_argument("a convex hull needs at least one point; got none");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((points[i].array().abs() <= kMostCoordinate).all()) continue;  // False for NaN.
    const std::string point = "hull point " + std::to_string(i);
    if (points[i].allFinite()) {
      std::ostringstream text;
      text << point << " must be within " << kMostCoordinate << " m of the origin; got (" << points[i].transpose()
           << ")";
      throw std::invalid_argument(text.str());
    }
    throw std::invalid_argument(point + " must be finite; got (" + std::to_string(points[i].x()) + ", " +
                                std::to_string(points[i].y()) + ", " + std::to_string(points[i].z()) + ")");
  }
}

/// The affine frame of a point set: a point, then up to three orthonormal axes, each along the farthest remaining
/// point.
struct AffineFrame {
  Vector3d origin;
  Vector3d axes[3];
  double reaches[3] = {0, 0, 0};  ///< Distance of the farthest point along each axis, metres.
  int dimension = 0;
};

AffineFrame FindAffineFrame(std::span<const Vector3d> points) {
  AffineFrame frame;
  frame.origin = points[0];
  double extent = 0;
  for (int dimension = 0; dimension < 3; ++dimension) {
    Vector3d farthest = Vector3d::Zero();
    for (const Vector3d& point : points) {
      Vector3d offset = point - frame.origin;
      // Twice, since one pass leaves a part of the order of roundoff, as large as what a flat set has left.
      for (int pass = 0; pass < 2; ++pass) {
        for (int axis = 0; axis < dimension; ++axis) offset -= frame.axes[axis] * frame.axes[axis].dot(offset);
      }
      if (offset.squaredNorm() > farthest.squaredNorm()) farthest = offset;
    }
    const double distance = farthest.stableNorm();
    frame.reaches[dimension] = distance;
    if (dimension == 0) extent = distance;
    if (!(distance > kFlatness * extent)) break;
    frame.axes[dimension] = farthest / distance;
    frame.dimension = dimension + 1;
  }
  return frame;
}

Vector3d MeanOf(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points) mean += point / static_cast<double>(points.size());
  return mean;
}

ConvexHull PointHull(std::span<const Vector3d> points) {
  ConvexHull hull;
  hull.vertices = {points[0]};
  hull.center = points[0];
  return hull;
}

ConvexHull SegmentHull(std::span<const Vector3d> points, const AffineFrame& frame) {
  const auto along = [&](const Vector3d& a, const Vector3d& b) { return frame.axes[0].dot(a - b) < 0; };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), along);
  ConvexHull hull;
  hull.dimension = 1;
  hull.vertices = {*low, *high};
  hull.center = (*low + *high) / 2;
  return hull;
}

/// Andrew's monotone chain in the plane of the first two axes; the facet is stored once for each side.
ConvexHull PlanarHull(std::span<const Vector3d> points, const AffineFrame& frame) {
  struct Projected {
    double x, y;
    std::size_t index;
  };
  std::vector<Projected> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d offset = points[i] - frame.origin;
    sorted.push_back({frame.axes[0].dot(offset), frame.axes[1].dot(offset), i});
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Projected& a, const Projected& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto turns_left = [](const Projected& a, const Projected& b, const Projected& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
  };
  std::vector<Projected> loop;
  for (int side = 0; side < 2; ++side) {
    const std::size_t floor = loop.size() + 1;
    for (const Projected& point : sorted) {
      while (loop.size() > floor && !turns_left(loop[loop.size() - 2], loop.back(), point)) loop.pop_back();
      loop.push_back(point);
    }
    loop.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }

  ConvexHull hull;
  hull.dimension = 2;
  std::vector<VertexId> order;
  for (const Projected& corner : loop) {
    order.push_back(static_cast<VertexId>(order.size()));
    hull.vertices.push_back(points[corner.index]);
  }
  const Vector3d normal = frame.axes[0].cross(frame.axes[1]);
  AddFacet(hull, normal, order);
  std::reverse(order.begin(), order.end());
  AddFacet(hull, -normal, order);

  double area = 0;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < hull.vertices.size(); ++i) {
    const Vector3d edge_1 = hull.vertices[i] - hull.vertices[0];
    const Vector3d edge_2 = hull.vertices[i + 1] - hull.vertices[0];
    const double part = normal.dot(edge_1.cross(edge_2));
    area += part;
    moment += part * (edge_1 + edge_2) / 3;
  }
  hull.center = area > 0 ? Vector3d(hull.vertices[0] + moment / area) : MeanOf(hull.vertices);
  return hull;
}

/// Owns a Qhull run: its memory is Qhull's own and is freed in two calls.
class QhullRun {
 public:
  QhullRun() {
    qh_zero(&qh_, nullptr);
    messages_ = open_memstream(&text_, &length_);
  }
  ~QhullRun() {
    qh_freeqhull(&qh_, !qh_ALL);
    int used = 0, total = 0;
    qh_memfreeshort(&qh_, &used, &total);
    if (messages_ != nullptr) std::fclose(messages_);
    std::free(text_);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  /// False if Qhull finds the points too flat for a hull. `coordinates` must outlive this.
  bool Run(std::vector<double>& coordinates) {
    char command[] = "qhull Pp";
    return qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False, command, nullptr,
                        messages_) == qh_ERRnone;
  }

  /// The first line of Qhull's message.
  std::string Message() {
    std::fflush(messages_);
    const std::string text(text_ == nullptr ? "" : text_, text_ == nullptr ? 0 : length_);
    return text.substr(0, text.find('\n'));
  }

  qhT* get() { return &qh_; }

 private:
  qhT qh_;
  std::FILE* messages_ = nullptr;
  char* text_ = nullptr;
  std::size_t length_ = 0;
};

/// The coordinates that Qhull is given, about a point of the set: its tolerances grow with the distance from the
/// origin. And with the extent, by which it merges the sides of a thin set with its faces, and loses what is a vertex
/// seen from above (fuzz_hull found four of five). Affine maps keep a hull's vertices and facets: so a thin set is
/// stretched.
class QhullCoordinates {
 public:
  explicit QhullCoordinates(const AffineFrame& frame)
      : origin_(frame.origin), is_stretched_(frame.reaches[2] < kThin * frame.reaches[0]) {
    for (int axis = 0; is_stretched_ && axis < 3; ++axis) to_qhull_.row(axis) = frame.axes[axis] / frame.reaches[axis];
    if (to_qhull_.determinant() < 0) to_qhull_.row(2) *= -1;
  }

  Vector3d ToQhull(const Vector3d& point) const {
    return is_stretched_ ? Vector3d(to_qhull_ * (point - origin_)) : Vector3d(point - origin_);
  }
  /// Unit normal of a plane of Qhull's.
  Vector3d NormalFromQhull(const Vector3d& normal) const {
    return is_stretched_ ? Vector3d((to_qhull_.transpose() * normal).normalized()) : normal;
  }

 private:
  /// Sets thinner than this part of their extent are stretched: far above the 6e-11 at which a vertex was lost. Thicker
  /// ones keep their own coordinates, and the exact normals of boxes.
  static constexpr double kThin = 1e-3;

  Vector3d origin_;
  Eigen::Matrix3d to_qhull_ = Eigen::Matrix3d::Identity();
  bool is_stretched_;
};

/// Copies Qhull's facets, with coplanar neighbours merged, and their vertices; `points` are what it was given.
void CopyFacets(qhT* qh, std::span<const Vector3d> points, const QhullCoordinates& coordinates, ConvexHull& hull) {
  std::vector<VertexId> renumbered(points.size(), kNoFeature);
  facetT* facet;
  FORALLfacet_(qh->facet_list) {
    setT* ordered = qh_facet3vertex(qh, facet);
    std::vector<std::size_t> corners;
    vertexT *vertex, **vertexp;
    FOREACHvertex_(ordered) corners.push_back(static_cast<std::size_t>(qh_pointid(qh, vertex->point)));
    qh_settempfree(qh, &ordered);
    if (corners.size() < 3) continue;  // It leaves no vertex behind that no facet has.

    std::vector<VertexId> loop;
    for (const std::size_t point : corners) {
      if (renumbered[point] == kNoFeature) {
        renumbered[point] = static_cast<VertexId>(hull.vertices.size());
        hull.vertices.push_back(points[point]);
      }
      loop.push_back(renumbered[point]);
    }

    // Newell's normal of the loop decides the order: counterclockwise seen from outside.
    const Vector3d outward(facet->normal[0], facet->normal[1], facet->normal[2]);
    const auto corner = [&](std::size_t i) { return coordinates.ToQhull(hull.vertices[loop[i]]); };
    Vector3d newell = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      newell += (corner(i) - corner(0)).cross(corner(i + 1) - corner(0));
    }
    if (newell.dot(outward) < 0) std::reverse(loop.begin(), loop.end());
    AddFacet(hull, coordinates.NormalFromQhull(outward), loop);
  }
}

/// Distance of the point to the nearest facet's plane, negative outside. A merged facet is not exactly flat: its
/// innermost vertex bounds the hull from inside.
double DepthOf(const Vector3d& point, const ConvexHull& hull) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
      const Vector3d& vertex = hull.vertices[hull.facet_vertices[static_cast<std::size_t>(i)]];
      depth = std::min(depth, hull.normals[facet].dot(vertex - point));
    }
  }
  return depth;
}

/// Centroid of the volume from tetrahedra over an inner point, then the largest ball about it.
void FindCenterAndInradius(ConvexHull& hull) {
  const Vector3d inner = MeanOf(hull.vertices);
  double volume = 0;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    const auto begin = static_cast<std::size_t>(hull.facet_start[facet]);
    const auto end = static_cast<std::size_t>(hull.facet_start[facet + 1]);
    const Vector3d a = hull.vertices[hull.facet_vertices[begin]] - inner;
    for (std::size_t i = begin + 1; i + 1 < end; ++i) {
      const Vector3d b = hull.vertices[hull.facet_vertices[i]] - inner;
      const Vector3d c = hull.vertices[hull.facet_vertices[i + 1]] - inner;
      const double part = a.dot(b.cross(c));
      volume += part;
      moment += part * (a + b + c) / 4;
    }
  }
  hull.center = volume > 0 ? Vector3d(inner + moment / volume) : inner;
  double inradius = DepthOf(hull.center, hull);
  // A needle's volume is less than the roundoff of its parts, and its centroid anywhere.
  if (!(inradius > 0)) {
    hull.center = inner;
    inradius = DepthOf(hull.center, hull);
  }
  double extent = 0;
  for (const Vector3d& vertex : hull.vertices) extent = std::max(extent, (vertex - hull.center).norm());
  // Roundoff of Qhull's normals, of the order of its own distance tolerance.
  constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();
  hull.inradius = std::max(0.0, inradius - kRounding * extent);
}

/// Points thicker than this part of their extent are not flattened where Qhull finds no hull: that would hide an error.
/// Coordinates rounded far from the origin may fail at some times kFlatness.
constexpr double kMaxFlattened = 100 * kFlatness;

[[noreturn]] void RefuseSolid(const AffineFrame& frame, const std::string& message) {
  std::ostringstream text;
  text << "Qhull finds no hull of points that reach " << frame.reaches[0] << ", " << frame.reaches[1] << " and "
       << frame.reaches[2] << " m along three axes: " << message;
  throw std::invalid_argument(text.str());
}

ConvexHull SolidHull(std::span<const Vector3d> points, const AffineFrame& frame) {
  const QhullCoordinates coordinates(frame);
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for (const Vector3d& point : points) {
    const Vector3d given = coordinates.ToQhull(point);
    numbers.insert(numbers.end(), given.begin(), given.end());
  }
  QhullRun run;
  if (!run.Run(numbers)) {
    if (frame.reaches[2] > kMaxFlattened * frame.reaches[0]) RefuseSolid(frame, run.Message());
    return PlanarHull(points, frame);
  }
  ConvexHull hull;
  hull.dimension = 3;
  CopyFacets(run.get(), points, coordinates, hull);
  FindCenterAndInradius(hull);
  return hull;
}

}  // namespace

void AddFacet(ConvexHull& hull, const Vector3d& normal, std::span<const VertexId> loop) {
  if (hull.facet_start.empty()) hull.facet_start.push_back(0);
  hull.normals.push_back(normal);
  hull.facet_vertices.insert(hull.facet_vertices.end(), loop.begin(), loop.end());
  hull.facet_start.push_back(static_cast<int>(hull.facet_vertices.size()));
}

// It is a counting sort over facet -> vertices.
void InvertFacets(ConvexHull& hull) {
  hull.vertex_start.assign(hull.vertices.size() + 1, 0);
  for (const VertexId vertex : hull.facet_vertices) ++hull.vertex_start[vertex + 1];
  std::partial_sum(hull.vertex_start.begin(), hull.vertex_start.end(), hull.vertex_start.begin());
  hull.vertex_facets.resize(hull.facet_vertices.size());
  std::vector<int> next = hull.vertex_start;
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
      const VertexId vertex = hull.facet_vertices[static_cast<std::size_t>(i)];
      hull.vertex_facets[static_cast<std::size_t>(next[vertex]++)] = static_cast<int>(facet);
    }
  }
}

ConvexHull BuildConvexHull(std::span<const Vector3d> points) {
  RequireFinitePoints(points);
  const AffineFrame frame = FindAffineFrame(points);
  ConvexHull hull;
  switch (frame.dimension) {
    case 0:
      return PointHull(points);
    case 1:
      return SegmentHull(points, frame);
    case 2:
      hull = PlanarHull(points, frame);
      break;
    default:
      hull = SolidHull(points, frame);
  }
  InvertFacets(hull);
  return hull;
}

}  // namespace dgd
