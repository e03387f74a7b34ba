// One random convex polytope, as in the paper's falling-polytope scene.
#pragma once

#include "scene/polyhedron.h"
#include "scene/random.h"

namespace dgd_demos {

/// Limits of `vertices`: a tetrahedron, and what still leaves room between random points on a sphere.
inline constexpr int kMinPolytopeVertices = 4;
inline constexpr int kMaxPolytopeVertices = 200;

/// Hull of random points on a random ellipsoid, every one of which is a vertex; centre of mass at the origin.
/// Needles and plates are drawn again, and so are pairs of vertices that almost coincide.
/// @param vertices  within the limits above.
/// @param diameter  greatest distance between two vertices, m, > 0.
Polyhedron RandomPolytope(Random& random, int vertices, double diameter);

}  // namespace dgd_demos
