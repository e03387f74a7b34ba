// One of the two polytopes of the incremental algorithm as the ray between the centres sees it.
#pragma once

#include <Eigen/Core>

#include "bench/textbook/half_edge_mesh.h"

namespace dgd_bench {

/// Twice the area of the triangle (0, a, b), positive counterclockwise.
inline double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Coordinates from the polytope's centre, metres: x and y across the ray, the same for both polytopes; z is the height
/// towards the other one, so that set 2's are left-handed.
class RaySide {
 public:
  /// A facet as a function of the place across the ray.
  struct Plane {
    double height;             ///< On the ray, metres.
    Eigen::Vector2d gradient;  ///< Of the height.
    bool is_facing;            ///< The other polytope. Else the facet is part of the far side, or upright.

    double At(const Eigen::Vector2d& place) const { return height + gradient.dot(place); }
  };

  /// @param to_ray  Turns offsets in the mesh's frame into these coordinates; determinant 1 or -1.
  RaySide(const HalfEdgeMesh& mesh, const Eigen::Matrix3d& to_ray, bool is_left_handed)
      : mesh_(mesh), to_ray_(to_ray), turn_(is_left_handed ? -1 : 1) {}

  const HalfEdgeMesh& Mesh() const { return mesh_; }

  Eigen::Vector3d Vertex(int vertex) const { return to_ray_ * mesh_.Vertex(vertex); }
  Eigen::Vector3d Origin(int edge) const { return to_ray_ * mesh_.Origin(edge); }
  Eigen::Vector3d Target(int edge) const { return to_ray_ * mesh_.Target(edge); }
  Eigen::Vector3d ToMesh(const Eigen::Vector3d& direction) const { return to_ray_.transpose() * direction; }

  Plane PlaneOf(int facet) const {
    const Eigen::Vector3d polar = to_ray_ * mesh_.Polar(facet);
    return {1 / polar.z(), -polar.head<2>() / polar.z(), polar.z() > 0};
  }
  bool IsFacing(int facet) const { return to_ray_.row(2).dot(mesh_.Polar(facet)) > 0; }
  /// Whether one of the facets around it is.
  bool IsVertexFacing(int vertex) const;
  bool IsEdgeFacing(int edge) const { return IsFacing(mesh_.Edge(edge).facet) || IsFacing(mesh_.Neighbor(edge)); }

  /// > 0 where `offset`, from any point of a side of a facing facet, points to that facet's inside.
  /// @param along  The side's direction, counterclockwise seen from outside.
  double Inwards(const Eigen::Vector2d& along, const Eigen::Vector2d& offset) const {
    return turn_ * Cross(along, offset);
  }

 private:
  const HalfEdgeMesh& mesh_;
  const Eigen::Matrix3d to_ray_;
  const double turn_;
};

inline bool RaySide::IsVertexFacing(int vertex) const {
  const int first = mesh_.EdgeFromVertex(vertex);
  int edge = first;
  do {
    if (IsFacing(mesh_.Edge(edge).facet)) return true;
    edge = mesh_.NextFromVertex(edge);
  } while (edge != first);
  return false;
}

}  // namespace dgd_bench
