#include "bench/textbook/incremental.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/textbook/ray_side.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd_bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Feature = IncrementalState::Feature;
using Type = IncrementalState::Type;

/// Unless the overlay is degenerate no feature comes twice, and sets have fewer.
constexpr int kMostSteps = 100'000;

/// A rise of less than this part of what it is the difference of is rounding.
constexpr double kRounding = 16 * dgd::kEpsilon<double>;

/// Coordinates of set 2 to those of set 1, and back: of a vector, or of a matrix's columns.
template <class Derived>
typename Derived::PlainObject Flipped(const Eigen::MatrixBase<Derived>& columns) {
  return Vector3d(1, 1, -1).asDiagonal() * columns;
}

class OverlayWalk {
 public:
  OverlayWalk(const HalfEdgeMesh& mesh_1, const dgd::Pose<double>& pose_1, const HalfEdgeMesh& mesh_2,
              const dgd::Pose<double>& pose_2)
      : center_1_(pose_1 * mesh_1.Center()),
        center_2_(pose_2 * mesh_2.Center()),
        length_((center_2_ - center_1_).norm()),
        frame_(dgd::FrameAlong<double>(Vector3d((center_2_ - center_1_) / length_))),
        sides_{RaySide(mesh_1, frame_.transpose() * pose_1.rotation, false),
               RaySide(mesh_2, Flipped(frame_.transpose() * pose_2.rotation), true)} {}

  /// To the facets that the ray meets from the centres; found from any facets, the sooner the nearer.
  void StartAtCenters(int facet_1, int facet_2) {
    on_ = {Feature{Type::kFacet, FacetOnRay(sides_[0], facet_1)},
           Feature{Type::kFacet, FacetOnRay(sides_[1], facet_2)}};
  }

  /// To the features of the last query, or to a vertex and the facet that it is over now.
  void Resume(const IncrementalState& state) {
    if (ResumeOverlay(state.on)) return;
    StartAtCenters(FacetAt(0, state.on[0]), FacetAt(1, state.on[1]));
  }

  /// One step upwards. False, and nothing done, at the top.
  bool Step() {
    ++steps_;
    if (on_[0].type == Type::kEdge) return StepFromCrossing();
    if (on_[0].type == Type::kVertex) return StepFromVertex(0);
    if (on_[1].type == Type::kVertex) return StepFromVertex(1);
    return StepFromCenters();
  }

  int Steps() const { return steps_; }
  const std::array<Feature, 2>& On() const { return on_; }

  /// Of the place from which the last step was tried.
  dgd::Result<double> MakeResult(bool is_optimal) const {
    const double length = points_[0].z() + points_[1].z();
    dgd::Result<double> result;
    result.status = is_optimal ? dgd::Status::kOptimal : dgd::Status::kIterationLimit;
    result.iterations = steps_;
    result.upper_bound = length_ / length;
    const Vector3d normal = normal_.normalized();
    result.lower_bound = is_optimal ? result.upper_bound : 0;  // Cut short, nothing is proven.
    result.separation = (length_ - length) * normal.z();
    result.normal = frame_ * normal;
    result.witness_1 = center_1_ + frame_ * points_[0];
    result.witness_2 = center_2_ + frame_ * Flipped(points_[1]);
    return result;
  }

 private:
  /// Along an edge of the overlay: from a point of an edge of set i, over a facet of the other.
  struct Move {
    int i = 0;
    int edge = -1;     ///< In the direction of the move.
    double start = 0;  ///< As a part of the edge.
    int facet = -1;
    int entered_by = -1;  ///< Side of the facet that the point is on.
    double rise = 0;      ///< Until the edge's end, metres.
    double terms = 0;     ///< Of the size of what the rise is the difference of.

    bool Rises() const { return rise > kRounding * terms; }
  };

  /// The ray's own facet of a set: the polar point farthest along it, by steps to neighbours.
  int FacetOnRay(const RaySide& side, int facet) {
    const HalfEdgeMesh& mesh = side.Mesh();
    const Vector3d ray = side.ToMesh(Vector3d::UnitZ());
    double farthest = ray.dot(mesh.Polar(facet));
    for (bool has_moved = true; has_moved; ++steps_) {
      has_moved = false;
      const int first = mesh.EdgeOfFacet(facet);
      int edge = first;
      do {
        const int neighbor = mesh.Neighbor(edge);
        const double reach = ray.dot(mesh.Polar(neighbor));
        if (reach > farthest) {
          farthest = reach;
          facet = neighbor;
          has_moved = true;
        }
        edge = mesh.Edge(edge).next;
      } while (edge != first);
    }
    return facet;
  }

  bool ResumeOverlay(const std::array<Feature, 2>& on) {
    if (on[0].type == Type::kEdge) return ResumeCrossing(on[0].index, on[1].index);
    if (on[0].type == Type::kVertex) return PutOverFacet(0, on[0].index, on[1].index);
    if (on[1].type == Type::kVertex) return PutOverFacet(1, on[1].index, on[0].index);
    return false;
  }

  bool ResumeCrossing(int edge_1, int edge_2) {
    if (!sides_[0].IsEdgeFacing(edge_1) || !sides_[1].IsEdgeFacing(edge_2)) return false;
    const std::array<int, 2> edges = {edge_1, edge_2};
    std::array<Vector3d, 2> origin, along;
    const std::array<double, 2> parts = CrossingOf(edges, origin, along);
    for (int i = 0; i < 2; ++i) {
      if (parts[i] >= 0 && parts[i] <= 1) continue;
      // An edge ends before the other: its end has come to lie over a facet.
      const HalfEdgeMesh& mesh = sides_[i].Mesh();
      const int end = mesh.Edge(parts[i] < 0.5 ? edges[i] : mesh.Edge(edges[i]).twin).origin;
      return PutOverFacet(i, end, FacingFacetOf(1 - i, edges[1 - i]));
    }
    on_ = {Feature{Type::kEdge, edge_1}, Feature{Type::kEdge, edge_2}};
    return true;
  }

  /// Walks over the other set's facets to the one that the vertex of set i lies over. False if the vertex is on the far
  /// side of its set, or beyond the border of the other.
  bool PutOverFacet(int i, int vertex, int facet) {
    if (!sides_[i].IsVertexFacing(vertex)) return false;
    const RaySide& ground = sides_[1 - i];
    const HalfEdgeMesh& mesh = ground.Mesh();
    const Vector2d place = sides_[i].Vertex(vertex).head<2>();
    int entered_by = -1;
    for (int left = mesh.FacetCount(); left > 0; --left, ++steps_) {
      if (!ground.IsFacing(facet)) return false;
      const int exit = SideTowards(ground, facet, place, entered_by);
      if (exit < 0) {
        on_[i] = {Type::kVertex, vertex};
        on_[1 - i] = {Type::kFacet, facet};
        return true;
      }
      entered_by = mesh.Edge(exit).twin;
      facet = mesh.Neighbor(exit);
    }
    return false;
  }

  /// The side of the facet beyond which the place lies farthest; -1 if it lies beyond none.
  static int SideTowards(const RaySide& ground, int facet, const Vector2d& place, int entered_by) {
    const HalfEdgeMesh& mesh = ground.Mesh();
    const int first = mesh.EdgeOfFacet(facet);
    int side = first, exit = -1;
    double least = 0;
    Vector2d corner = ground.Origin(side).head<2>();
    do {
      const int next = mesh.Edge(side).next;
      const Vector2d next_corner = ground.Origin(next).head<2>();
      const double inwards = ground.Inwards(next_corner - corner, place - corner);
      if (inwards < least && side != entered_by) {
        least = inwards;
        exit = side;
      }
      corner = next_corner;
      side = next;
    } while (side != first);
    return exit;
  }

  /// From both facets that the ray meets: up the steepest way until the first of them ends, and along its border.
  bool StepFromCenters() {
    const std::array<RaySide::Plane, 2> planes = {sides_[0].PlaneOf(on_[0].index), sides_[1].PlaneOf(on_[1].index)};
    const Vector2d uphill = planes[0].gradient + planes[1].gradient;
    for (int i = 0; i < 2; ++i) points_[i] = {0, 0, planes[i].height};
    normal_ << -planes[0].gradient, 1;
    if (uphill.norm() <= kRounding * (planes[0].gradient.norm() + planes[1].gradient.norm())) return false;

    Move move;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      const auto [distance, side] = BorderAlong(sides_[i], on_[i].index, Vector2d::Zero(), uphill, 0, -1);
      if (side < 0 || !(distance < nearest)) continue;
      nearest = distance;
      move.i = i;
      move.edge = side;
      move.facet = on_[1 - i].index;
    }
    const Vector3d origin = sides_[move.i].Origin(move.edge);
    const Vector3d along = sides_[move.i].Target(move.edge) - origin;
    move.start = (nearest * uphill - origin.head<2>()).dot(along.head<2>()) / along.head<2>().squaredNorm();
    if (along.z() + planes[1 - move.i].gradient.dot(along.head<2>()) < 0) {
      move.edge = sides_[move.i].Mesh().Edge(move.edge).twin;
      move.start = 1 - move.start;
    }
    Make(move);
    return true;
  }

  /// From a vertex of set i over a facet of the other: along one of the vertex's edges.
  bool StepFromVertex(int i) {
    const HalfEdgeMesh& mesh = sides_[i].Mesh();
    const int vertex = on_[i].index, facet = on_[1 - i].index;
    const RaySide::Plane plane = sides_[1 - i].PlaneOf(facet);
    points_[i] = sides_[i].Vertex(vertex);
    points_[1 - i] << points_[i].head<2>(), plane.At(points_[i].head<2>());
    const Vector3d up(plane.gradient.x(), plane.gradient.y(), 1);
    normal_ = i == 0 ? up : Vector3d(-up.x(), -up.y(), 1);

    const Vector3d up_in_mesh = sides_[i].ToMesh(up);
    const Vector3d& from = mesh.Vertex(vertex);
    Move best{.i = i, .facet = facet};
    const int first = mesh.EdgeFromVertex(vertex);
    int edge = first;
    do {
      const double rise = up_in_mesh.dot(mesh.Target(edge) - from);
      // At the border of the set's map some edges lie below it, on the far side.
      if (rise > best.rise && sides_[i].IsEdgeFacing(edge)) {
        best.rise = rise;
        best.edge = edge;
      }
      edge = mesh.NextFromVertex(edge);
    } while (edge != first);
    if (best.edge < 0) return false;
    best.terms = up.norm() * (mesh.Target(best.edge) - from).norm();
    if (!best.Rises()) return false;
    Make(best);
    return true;
  }

  /// From the crossing of two edges: along one of them, either way.
  bool StepFromCrossing() {
    const std::array<int, 2> edges = {on_[0].index, on_[1].index};
    std::array<Vector3d, 2> origin, along;
    const std::array<double, 2> parts = CrossingOf(edges, origin, along);
    for (int i = 0; i < 2; ++i) points_[i] = origin[i] + parts[i] * along[i];
    normal_ = along[0].cross(Flipped(along[1]));
    if (normal_.z() < 0) normal_ *= -1;

    Move best;
    for (int i = 0; i < 2; ++i) {
      for (const bool is_forward : {true, false}) {
        const Move move = MoveFromCrossing(i, is_forward, edges, along, parts[i]);
        if (move.Rises() && move.rise > best.rise) best = move;
      }
    }
    if (best.edge < 0) return false;
    Make(best);
    return true;
  }

  /// One of the four ways: along set i's edge. It does not rise if it leads beyond the border of the other set.
  Move MoveFromCrossing(int i, bool is_forward, const std::array<int, 2>& edges, const std::array<Vector3d, 2>& along,
                        double part) const {
    const RaySide& ground = sides_[1 - i];
    const int crossed = edges[1 - i], twin = ground.Mesh().Edge(crossed).twin;
    const Vector3d step = is_forward ? along[i] : Vector3d(-along[i]);
    const bool is_to_the_left = ground.Inwards(along[1 - i].head<2>(), step.head<2>()) > 0;
    Move move{.i = i, .entered_by = is_to_the_left ? crossed : twin};
    move.facet = ground.Mesh().Edge(move.entered_by).facet;
    const RaySide::Plane plane = ground.PlaneOf(move.facet);
    if (!plane.is_facing) return move;
    move.edge = is_forward ? edges[i] : sides_[i].Mesh().Edge(edges[i]).twin;
    move.start = is_forward ? part : 1 - part;
    move.rise = (1 - move.start) * (step.z() + plane.gradient.dot(step.head<2>()));
    move.terms = (1 - move.start) * (std::abs(step.z()) + plane.gradient.norm() * step.head<2>().norm());
    return move;
  }

  /// To the next vertex of the overlay.
  void Make(const Move& move) {
    const Vector3d origin = sides_[move.i].Origin(move.edge);
    const Vector2d along = (sides_[move.i].Target(move.edge) - origin).head<2>();
    const auto [part, side] =
        BorderAlong(sides_[1 - move.i], move.facet, origin.head<2>(), along, move.start, move.entered_by);
    if (side >= 0 && part < 1) {
      on_[move.i] = {Type::kEdge, move.edge};
      on_[1 - move.i] = {Type::kEdge, side};
    } else {
      const HalfEdgeMesh& mesh = sides_[move.i].Mesh();
      on_[move.i] = {Type::kVertex, mesh.Edge(mesh.Edge(move.edge).twin).origin};
      on_[1 - move.i] = {Type::kFacet, move.facet};
    }
  }

  /// Where the line origin + part * along leaves a facet, no sooner than `start`: the part, and the facet's side.
  static std::pair<double, int> BorderAlong(const RaySide& ground, int facet, const Vector2d& origin,
                                            const Vector2d& along, double start, int entered_by) {
    const HalfEdgeMesh& mesh = ground.Mesh();
    std::pair<double, int> border = {std::numeric_limits<double>::infinity(), -1};
    const int first = mesh.EdgeOfFacet(facet);
    int side = first;
    Vector2d corner = ground.Origin(side).head<2>();
    do {
      const int next = mesh.Edge(side).next;
      const Vector2d next_corner = ground.Origin(next).head<2>();
      const double outwards = -ground.Inwards(next_corner - corner, along);
      if (outwards > 0 && side != entered_by) {
        const double part = std::max(start, ground.Inwards(next_corner - corner, origin - corner) / outwards);
        if (part < border.first) border = {part, side};
      }
      corner = next_corner;
      side = next;
    } while (side != first);
    return border;
  }

  /// Where on each of two edges, as a part of it from its origin, they cross seen along the ray.
  std::array<double, 2> CrossingOf(const std::array<int, 2>& edges, std::array<Vector3d, 2>& origin,
                                   std::array<Vector3d, 2>& along) const {
    for (int i = 0; i < 2; ++i) {
      origin[i] = sides_[i].Origin(edges[i]);
      along[i] = sides_[i].Target(edges[i]) - origin[i];
    }
    const Vector2d between = (origin[1] - origin[0]).head<2>();
    const double area = Cross(along[0].head<2>(), along[1].head<2>());
    return {Cross(between, along[1].head<2>()) / area, Cross(between, along[0].head<2>()) / area};
  }

  int FacingFacetOf(int i, int edge) const {
    const HalfEdgeMesh& mesh = sides_[i].Mesh();
    const int facet = mesh.Edge(edge).facet;
    return sides_[i].IsFacing(facet) ? facet : mesh.Neighbor(edge);
  }

  int FacetAt(int i, const Feature& feature) const {
    const HalfEdgeMesh& mesh = sides_[i].Mesh();
    if (feature.type == Type::kFacet) return feature.index;
    return mesh.Edge(feature.type == Type::kEdge ? feature.index : mesh.EdgeFromVertex(feature.index)).facet;
  }

  const Vector3d center_1_, center_2_;
  const double length_;   // |p|.
  const Matrix3d frame_;  // Columns: across the ray, and along it from set 1 to set 2; world.
  const std::array<RaySide, 2> sides_;
  std::array<Feature, 2> on_;
  int steps_ = 0;
  std::array<Vector3d, 2> points_;  // Of each set, in its coordinates, at the same place.
  Vector3d normal_;                 // In set 1's coordinates, towards set 2, of any length.
};

}  // namespace

dgd::Result<double> IncrementalGrowthDistance(const HalfEdgeMesh& mesh_1, const dgd::Pose<double>& pose_1,
                                              const HalfEdgeMesh& mesh_2, const dgd::Pose<double>& pose_2,
                                              IncrementalState* state) {
  OverlayWalk walk(mesh_1, pose_1, mesh_2, pose_2);
  if (state != nullptr && !state->is_empty) {
    walk.Resume(*state);
  } else {
    walk.StartAtCenters(0, 0);
  }
  bool is_optimal = false;
  do {
    is_optimal = !walk.Step();
  } while (!is_optimal && walk.Steps() < kMostSteps);
  if (state != nullptr) *state = {walk.On(), false};
  return walk.MakeResult(is_optimal);
}

}  // namespace dgd_bench
