#include "support/distance_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace dgd_test {
namespace {

using Vector = Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of the set's size: what rounding leaves of its points, and the bounds are not brought nearer than.
constexpr double kNegligible = 1e-15;

/// Some points of a convex set: at most four, the corners of a simplex.
struct Simplex {
  std::array<Vector, 4> points;
  int size = 0;

  const Vector& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
  void Add(const Vector& point) { points[static_cast<std::size_t>(size++)] = point; }
};

/// The point of a segment's line, or a triangle's plane, that is nearest to the origin; false if it is not inside.
bool NearestInside(const Vector& a, const Vector& b, Vector& nearest) {
  const Vector edge = b - a;
  const double along = -a.dot(edge), whole = edge.squaredNorm();
  if (!(along >= 0 && along <= whole && whole > 0)) return false;
  nearest = a + along / whole * edge;
  return true;
}

bool NearestInside(const Vector& a, const Vector& b, const Vector& c, Vector& nearest) {
  const Vector normal = (b - a).cross(c - a);
  const double area_sq = normal.squaredNorm();
  if (!(area_sq > 0)) return false;
  if (normal.dot(b.cross(c)) < 0 || normal.dot(c.cross(a)) < 0 || normal.dot(a.cross(b)) < 0) return false;
  nearest = normal.dot(a) / area_sq * normal;
  return true;
}

bool ContainsOrigin(const Simplex& s) {
  const double whole = (s[1] - s[0]).cross(s[2] - s[0]).dot(s[3] - s[0]);
  const double parts[] = {-s[1].cross(s[2]).dot(s[3]), s[0].cross(s[2]).dot(s[3]), -s[0].cross(s[1]).dot(s[3]),
                          s[0].cross(s[1]).dot(s[2])};
  return std::ranges::all_of(parts, [&](double part) { return -part * whole > 0; });
}

/// The point of the simplex nearest to the origin, by trying every face of it; keeps that face.
Vector NearestPoint(Simplex& simplex) {
  if (simplex.size == 4 && ContainsOrigin(simplex)) return Vector::Zero();
  Simplex best_face = simplex;
  Vector best = Vector::Zero();
  double best_norm = kInfinity;
  const auto try_face = [&](bool is_inside, const Vector& nearest, std::initializer_list<int> corners) {
    if (!is_inside || !(nearest.norm() < best_norm)) return;
    best = nearest;
    best_norm = nearest.norm();
    best_face.size = 0;
    for (const int corner : corners) best_face.Add(simplex[corner]);
  };
  Vector nearest = Vector::Zero();
  for (int i = 0; i < simplex.size; ++i) {
    try_face(true, simplex[i], {i});
    for (int j = 0; j < i; ++j) {
      try_face(NearestInside(simplex[i], simplex[j], nearest), nearest, {i, j});
      for (int k = 0; k < j; ++k) {
        try_face(NearestInside(simplex[i], simplex[j], simplex[k], nearest), nearest, {i, j, k});
      }
    }
  }
  simplex = best_face;
  return best;
}

/// The bounds as points and planes come in.
class Bounds {
 public:
  explicit Bounds(const SupportFunction& support) : support_(support) {}

  /// The supporting plane along `normal`, a unit vector outward of the set.
  /// @return the point of the set that is on it.
  Vector AddPlane(const Vector& normal) {
    const Vector point = support_(normal);
    size_ = std::max(size_, point.norm());
    const double separation = -normal.dot(point);
    if (separation > bounds_.lower) {
      bounds_.lower = separation;
      bounds_.normal = normal;
    }
    return point;
  }
  void AddUpper(double upper) { bounds_.upper = std::min(bounds_.upper, upper); }

  bool Meet() const { return bounds_.upper - bounds_.lower <= kNegligible * size_; }
  double Size() const { return size_; }
  const DistanceBounds& Get() const { return bounds_; }

 private:
  const SupportFunction& support_;
  DistanceBounds bounds_{-kInfinity, kInfinity, Vector::Zero()};
  double size_ = 0;
};

/// Closes the bounds in if the origin is outside.
/// @return whether it is, or on the surface.
bool BoundFromOutside(Bounds& bounds) {
  constexpr int kMaxSteps = 300;
  Simplex simplex;
  simplex.Add(bounds.AddPlane(Vector::UnitZ()));
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vector nearest = NearestPoint(simplex);
    bounds.AddUpper(nearest.norm());
    if (nearest.norm() <= kNegligible * bounds.Size()) return false;
    const Vector farthest = bounds.AddPlane(-nearest.normalized());
    const auto end = simplex.points.begin() + simplex.size;
    if (bounds.Meet() || std::find(simplex.points.begin(), end, farthest) != end) break;
    simplex.Add(farthest);
  }
  return true;
}

/// A polytope in the set that grows, by triangles.
class InnerPolytope {
 public:
  /// @param corners  Of a tetrahedron that is not flat.
  InnerPolytope(const std::array<Vector, 4>& corners, double size)
      : points_(corners.begin(), corners.end()), negligible_(kNegligible * size) {
    const bool is_positive = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) > 0;
    static constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const auto& face : kFaces) {
      AddFacet(face[0], is_positive ? face[1] : face[2], is_positive ? face[2] : face[1]);
    }
  }

  struct Facet {
    std::array<int, 3> corners;
    Vector normal;  // Unit, outward.
    double height;  // Of the plane over the origin: positive if the origin is on the inner side.
    bool is_final = false;
  };

  /// The facet nearest to the origin of those that are not final; null if all are.
  Facet* NearestOpen() {
    Facet* nearest = nullptr;
    for (Facet& facet : facets_) {
      if (!facet.is_final && (nearest == nullptr || facet.height < nearest->height)) nearest = &facet;
    }
    return nearest;
  }
  /// Of all facets.
  double LeastHeight() const {
    double least = kInfinity;
    for (const Facet& facet : facets_) least = std::min(least, facet.height);
    return least;
  }

  /// @return false if the point is in the polytope, as far as rounding tells, or its facets would not close.
  bool Add(const Vector& point) {
    std::vector<std::pair<int, int>> edges;
    const auto is_seen = [&](const Facet& facet) { return facet.normal.dot(point) > facet.height + negligible_; };
    for (const Facet& facet : facets_) {
      if (!is_seen(facet)) continue;
      for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(facet.corners[i], facet.corners[(i + 1) % 3]);
    }
    if (edges.empty()) return false;
    std::vector<std::pair<int, int>> horizon;
    for (const auto& [from, to] : edges) {
      if (std::ranges::find(edges, std::pair(to, from)) == edges.end()) horizon.emplace_back(from, to);
    }
    // One loop: each of its corners begins one edge.
    std::vector<int> starts;
    for (const auto& edge : horizon) starts.push_back(edge.first);
    std::ranges::sort(starts);
    if (horizon.size() < 3 || std::ranges::adjacent_find(starts) != starts.end()) return false;
    std::erase_if(facets_, is_seen);
    points_.push_back(point);
    for (const auto& [from, to] : horizon) AddFacet(from, to, static_cast<int>(points_.size()) - 1);
    return true;
  }

 private:
  void AddFacet(int a, int b, int c) {
    const Vector &p = Point(a), &q = Point(b), &r = Point(c);
    // About the corner between the two shortest sides, where rounding is least.
    Vector normal = (q - p).cross(r - p);
    const double pq = (q - p).squaredNorm(), qr = (r - q).squaredNorm(), rp = (p - r).squaredNorm();
    if (pq >= qr && pq >= rp) normal = (p - r).cross(q - r);
    if (rp > pq && rp >= qr) normal = (r - q).cross(p - q);
    if (!(normal.squaredNorm() > 0)) return;  // Of no area: nothing lies beyond it that is not beyond its neighbours.
    normal.normalize();
    facets_.push_back({{a, b, c}, normal, std::min({normal.dot(p), normal.dot(q), normal.dot(r)})});
  }
  const Vector& Point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  std::vector<Vector> points_;
  std::vector<Facet> facets_;
  double negligible_;
};

/// Four points of the set that span as much as they can; false if they are flat.
bool SpanTetrahedron(Bounds& bounds, std::array<Vector, 4>& corners) {
  // Along no direction that shapes are built along.
  const Vector anyhow(0.48, 0.6, 0.64);
  constexpr double kFlat = 1e-9;  // Of the longest edge.
  const auto farther = [&](const Vector& direction, const Vector& from) {
    const Vector a = bounds.AddPlane(direction), b = bounds.AddPlane(-direction);
    return std::abs((a - from).dot(direction)) > std::abs((b - from).dot(direction)) ? a : b;
  };
  corners[0] = bounds.AddPlane(anyhow);
  corners[1] = farther(anyhow, corners[0]);
  const Vector edge = corners[1] - corners[0];
  if (!(edge.norm() > 0)) return false;
  corners[2] = farther(edge.unitOrthogonal(), corners[0]);
  const Vector normal = edge.cross(corners[2] - corners[0]);
  if (!(normal.norm() > kFlat * edge.squaredNorm())) return false;
  corners[3] = farther(normal.normalized(), corners[0]);
  return std::abs((corners[3] - corners[0]).dot(normal.normalized())) > kFlat * edge.norm();
}

/// Closes the bounds in if the origin is inside.
void BoundFromInside(Bounds& bounds) {
  constexpr int kMaxSteps = 600;
  std::array<Vector, 4> corners;
  if (!SpanTetrahedron(bounds, corners)) return;
  InnerPolytope polytope(corners, bounds.Size());
  for (int step = 0; step < kMaxSteps; ++step) {
    // Of a polytope that has slivers, an earlier one may have been better.
    if (polytope.LeastHeight() >= 0) bounds.AddUpper(-polytope.LeastHeight());
    InnerPolytope::Facet* nearest = polytope.NearestOpen();
    if (bounds.Meet() || nearest == nullptr || nearest->height >= -bounds.Get().lower) break;
    const Vector point = bounds.AddPlane(nearest->normal);
    if (!polytope.Add(point)) nearest->is_final = true;
  }
}

}  // namespace

DistanceBounds BoundDistanceToOrigin(const SupportFunction& support) {
  Bounds bounds(support);
  if (!BoundFromOutside(bounds)) BoundFromInside(bounds);
  return bounds.Get();
}

}  // namespace dgd_test
