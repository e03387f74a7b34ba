// Surfaces of shapes as they collide: the core with its ball around every point, faces pushed out and edges and corners
// rounded. Flat where the shape is flat, smooth where it is round.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "scene/polyhedron.h"
#include "scene/pose.h"
#include "scene/shape.h"

namespace dgd_demos {

struct SurfaceVertex {
  Eigen::Vector3f position;  ///< In the body's frame, m.
  Eigen::Vector3f normal;    ///< Outward, unit.
};

/// Three vertices a triangle, counter-clockwise seen from outside.
using SurfaceMesh = std::vector<SurfaceVertex>;

/// The surface of a body with this collision margin.
SurfaceMesh SurfaceOf(const Shape& shape, double margin);

/// The surface of a body that has both sides, such as a triangle mesh: each triangle once for either.
/// @param corners  three a triangle, in any sense; those of triangles without an area are left out.
SurfaceMesh TwoSidedSurface(const std::vector<Eigen::Vector3d>& corners);

/// Adds a part's surface. @param pose  of the part in the body's frame.
void Append(const SurfaceMesh& part, const Pose& pose, SurfaceMesh& mesh);

/// Greatest distance of a vertex from the origin, m.
double BoundingRadius(const SurfaceMesh& mesh);

/// The surface of core + ball. @pre core.IsSolid().
SurfaceMesh RoundedPolyhedronSurface(const Polyhedron& core, double radius);

/// The surface of core + ball, where the core is a convex profile turned about z.
/// @param profile  corners (distance from z, height) from the lower end on the axis to the upper one; one corner for a
///                 point, two for a segment.
SurfaceMesh RoundedRevolutionSurface(const std::vector<Eigen::Vector2d>& profile, double radius);

}  // namespace dgd_demos
