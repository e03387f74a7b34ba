#include "simulation/signed_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "simulation/feature_distance.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Sine of the angle between two edges below which they are parallel: the normal of their cross product is lost in
// rounding, and where it would be needed, a face normal is within this angle of it.
constexpr double kParallelSine = 1e-10;

// Share of the coordinates' magnitude below which the length of a connection is rounding, and its direction chance.
constexpr double kLeastRelativeLength = 1e-12;

struct Interval {
  double low, high;
};

Interval Project(const Vector3d& unit, const PosedPolyhedron& polyhedron) {
  Interval interval{kInfinity, -kInfinity};
  for (const Vector3d& vertex : polyhedron.vertices) {
    const double height = unit.dot(vertex);
    interval.low = std::min(interval.low, height);
    interval.high = std::max(interval.high, height);
  }
  return interval;
}

// The best axis so far, for the search over separating axes.
class BestAxis {
 public:
  BestAxis(const PosedPolyhedron& a, const PosedPolyhedron& b) : a_(a), b_(b) {}

  void TryFromAToB(const Vector3d& unit) {
    const double separation = SeparationAlong(unit, a_, b_);
    if (separation > best_.value) best_ = {separation, unit};
  }
  bool IsSeparating() const { return best_.value > 0; }
  const SignedDistance& best() const { return best_; }

 private:
  const PosedPolyhedron& a_;
  const PosedPolyhedron& b_;
  SignedDistance best_{-kInfinity, Vector3d::UnitX()};
};

void TryFaceNormals(const PosedPolyhedron& a, const PosedPolyhedron& b, BestAxis& axis) {
  for (const Polyhedron::Face& face : a.faces) axis.TryFromAToB(face.normal);
  for (const Polyhedron::Face& face : b.faces) axis.TryFromAToB(-face.normal);
}

// An edge as the search sees it: its direction, and its arc on the Gauss map, the shorter way between two normals.
struct GaussEdge {
  Vector3d point, direction;
  bool has_arc;  // Without faces beside it, an edge's arc is the whole great circle across it.
  Vector3d arc_start, arc_end;
};

// Edges of `polyhedron`; with `sign` -1, of its mirror image in the origin, as the Minkowski difference has them.
std::vector<GaussEdge> GaussEdges(const PosedPolyhedron& polyhedron, double sign) {
  std::vector<GaussEdge> edges;
  for (const Polyhedron::Edge& edge : *polyhedron.edges) {
    const Vector3d& start = polyhedron.vertices[edge.vertices[0]];
    const Vector3d direction = polyhedron.vertices[edge.vertices[1]] - start;
    if (direction.isZero(0)) continue;
    GaussEdge gauss{start, direction.normalized(), edge.faces[0] != Polyhedron::kNoFace, {}, {}};
    if (gauss.has_arc) {
      gauss.arc_start = sign * polyhedron.faces[edge.faces[0]].normal;
      gauss.arc_end = sign * polyhedron.faces[edge.faces[1]].normal;
    }
    edges.push_back(gauss);
  }
  return edges;
}

// Whether the arc of `edge` has points on both sides of the plane through the origin across `normal`, or in it.
bool ArcMeetsPlane(const GaussEdge& edge, const Vector3d& normal) {
  return !edge.has_arc || normal.dot(edge.arc_start) * normal.dot(edge.arc_end) <= 0;
}

// Whether `unit` lies within the lune of the arc; it is known to be on the arc's great circle.
bool IsOnArc(const Vector3d& unit, const GaussEdge& edge) {
  return !edge.has_arc || unit.dot(edge.arc_start + edge.arc_end) > 0;
}

// The cross products of edge pairs. An edge's arc lies in the plane across the edge, so two arcs can only cross if each
// meets the other's plane; the normal is then the common line of both planes, in that one of its two senses which is
// on both arcs. The test may err towards yes: any axis gives a valid lower bound.
void TryEdgePairs(const PosedPolyhedron& a, const PosedPolyhedron& b, BestAxis& axis) {
  const std::vector<GaussEdge> edges_of_a = GaussEdges(a, 1);
  const std::vector<GaussEdge> edges_of_b = GaussEdges(b, -1);
  for (const GaussEdge& edge_a : edges_of_a) {
    for (const GaussEdge& edge_b : edges_of_b) {
      if (!ArcMeetsPlane(edge_a, edge_b.direction) || !ArcMeetsPlane(edge_b, edge_a.direction)) continue;
      const Vector3d cross = edge_a.direction.cross(edge_b.direction);
      const double sine = cross.norm();
      if (sine < kParallelSine) continue;
      for (const Vector3d& unit : {Vector3d(cross / sine), Vector3d(-cross / sine)}) {
        if (!IsOnArc(unit, edge_a) || !IsOnArc(unit, edge_b)) continue;
        // The two edges support the axis: this is its separation, cheaper than over all vertices.
        const double separation = unit.dot(edge_b.point - edge_a.point);
        if (separation > axis.best().value) axis.TryFromAToB(unit);
      }
    }
  }
}

// Finds the shortest connection of two polyhedra that a known axis separates. Heights along that axis tell which
// features cannot be part of it: their heights alone are further apart than the best connection so far.
class ShortestConnection {
 public:
  ShortestConnection(const PosedPolyhedron& a, const PosedPolyhedron& b, const Vector3d& axis)
      : a_(a), b_(b), heights_of_a_(Heights(a, axis)), heights_of_b_(Heights(b, axis)) {}

  Connection Find() {
    TryVertexPairs();
    TryEdgePairs();
    TryVerticesAgainstFaces();
    return best_;
  }

 private:
  static std::vector<double> Heights(const PosedPolyhedron& polyhedron, const Vector3d& axis) {
    std::vector<double> heights;
    for (const Vector3d& vertex : polyhedron.vertices) heights.push_back(axis.dot(vertex));
    return heights;
  }

  template <std::size_t N>
  static double Lowest(const std::array<int, N>& corners, const std::vector<double>& heights) {
    double lowest = kInfinity;
    for (const int v : corners) lowest = std::min(lowest, heights[v]);
    return lowest;
  }
  template <std::size_t N>
  static double Highest(const std::array<int, N>& corners, const std::vector<double>& heights) {
    double highest = -kInfinity;
    for (const int v : corners) highest = std::max(highest, heights[v]);
    return highest;
  }

  void Consider(const Connection& connection) {
    if (connection.distance < best_.distance) best_ = connection;
  }

  // Not needed for the result, as edges include their ends; a good start for what follows.
  void TryVertexPairs() {
    for (const Vector3d& on_a : a_.vertices) {
      for (const Vector3d& on_b : b_.vertices) Consider({(on_b - on_a).norm(), on_a, on_b});
    }
  }

  void TryEdgePairs() {
    const double lowest_of_b = *std::ranges::min_element(heights_of_b_);
    for (const Polyhedron::Edge& edge_a : *a_.edges) {
      const double height_a = Highest(edge_a.vertices, heights_of_a_);
      if (lowest_of_b - height_a > best_.distance) continue;
      const Segment segment_a = {a_.vertices[edge_a.vertices[0]], a_.vertices[edge_a.vertices[1]]};
      for (const Polyhedron::Edge& edge_b : *b_.edges) {
        if (Lowest(edge_b.vertices, heights_of_b_) - height_a > best_.distance) continue;
        Consider(Connect(segment_a, {b_.vertices[edge_b.vertices[0]], b_.vertices[edge_b.vertices[1]]}));
      }
    }
  }

  void TryVerticesAgainstFaces() {
    for (std::size_t v = 0; v < a_.vertices.size(); ++v) {
      for (const Polyhedron::Face& face : b_.faces) {
        if (Lowest(face.vertices, heights_of_b_) - heights_of_a_[v] > best_.distance) continue;
        if (const auto found = ConnectToInside(a_.vertices[v], Corners(face, b_), face.normal)) Consider(*found);
      }
    }
    for (std::size_t v = 0; v < b_.vertices.size(); ++v) {
      for (const Polyhedron::Face& face : a_.faces) {
        if (heights_of_b_[v] - Highest(face.vertices, heights_of_a_) > best_.distance) continue;
        const auto found = ConnectToInside(b_.vertices[v], Corners(face, a_), face.normal);
        if (found) Consider({found->distance, found->on_second, found->on_first});
      }
    }
  }

  static Triangle Corners(const Polyhedron::Face& face, const PosedPolyhedron& polyhedron) {
    return {polyhedron.vertices[face.vertices[0]], polyhedron.vertices[face.vertices[1]],
            polyhedron.vertices[face.vertices[2]]};
  }

  const PosedPolyhedron& a_;
  const PosedPolyhedron& b_;
  const std::vector<double> heights_of_a_, heights_of_b_;
  Connection best_{kInfinity, Vector3d::Zero(), Vector3d::Zero()};
};

// Distance of polyhedra that do not overlap. `axis` separates them, or is arbitrary if neither has an inside.
SignedDistance DistanceApart(const PosedPolyhedron& a, const PosedPolyhedron& b, const SignedDistance& axis) {
  const Connection shortest = ShortestConnection(a, b, axis.normal).Find();
  const bool has_direction = shortest.distance > kLeastRelativeLength * shortest.on_first.norm();
  if (!has_direction) return {shortest.distance, axis.normal};
  return {shortest.distance, (shortest.on_second - shortest.on_first) / shortest.distance};
}

}  // namespace

PosedPolyhedron::PosedPolyhedron(const Polyhedron& polyhedron, const Pose& pose)
    : faces(polyhedron.faces), edges(&polyhedron.edges) {
  vertices.reserve(polyhedron.vertices.size());
  for (const Vector3d& vertex : polyhedron.vertices) vertices.push_back(pose * vertex);
  for (Polyhedron::Face& face : faces) face.normal = (pose.rotation * face.normal).normalized();
}

double SeparationAlong(const Vector3d& unit, const PosedPolyhedron& a, const PosedPolyhedron& b) {
  return Project(unit, b).low - Project(unit, a).high;
}

SignedDistance ComputeSignedDistance(const PosedPolyhedron& a, const PosedPolyhedron& b) {
  BestAxis axis(a, b);
  if (a.faces.empty() && b.faces.empty()) return DistanceApart(a, b, axis.best());

  TryFaceNormals(a, b, axis);
  if (!axis.IsSeparating()) TryEdgePairs(a, b, axis);
  return axis.IsSeparating() ? DistanceApart(a, b, axis.best()) : axis.best();
}

}  // namespace dgd_demos
