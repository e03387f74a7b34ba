// Convex polyhedra by their features. The oracle walks over them, the renderer draws them, Bullet gets their vertices.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace dgd_demos {

/// A convex polyhedron: vertices in metres, faces as triangles (coplanar ones where a face has more corners).
/// A point (one vertex) and a segment (two vertices, one edge) are polyhedra without faces.
struct Polyhedron {
  struct Face {
    std::array<int, 3> vertices;  ///< Indices, counter-clockwise seen from outside.
    Eigen::Vector3d normal;       ///< Outward, unit length.
  };
  struct Edge {
    std::array<int, 2> vertices;  ///< Indices; equal for the single "edge" of a point.
    std::array<int, 2> faces;     ///< Indices of the two adjacent faces; kNoFace for points and segments.
  };
  static constexpr int kNoFace = -1;

  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
  std::vector<Edge> edges;  ///< Between faces at an angle; the diagonals inside a flat face are left out.

  bool IsSolid() const { return !faces.empty(); }
};

/// Hull of the points by Qhull; `vertices` are the extreme points, in the order of their first appearance.
/// @throws std::invalid_argument with Qhull's reason if there are fewer than 4 points or they lie in a plane.
Polyhedron ConvexHull(const std::vector<Eigen::Vector3d>& points);

Polyhedron PointPolyhedron();
/// From -half_length to half_length along z.
Polyhedron SegmentPolyhedron(double half_length);

/// Centre of mass of the solid at uniform density. @pre polyhedron.IsSolid().
Eigen::Vector3d Centroid(const Polyhedron& polyhedron);

/// Distance from `point` to the nearest face plane; negative if the point is outside. @pre polyhedron.IsSolid().
double DistanceToBoundary(const Polyhedron& polyhedron, const Eigen::Vector3d& point);

/// Greatest distance of a vertex from the origin.
double BoundingRadius(const Polyhedron& polyhedron);

}  // namespace dgd_demos
