// The exact signed distance of two convex polyhedra, by brute force: slow, short, and sharing nothing with the solvers
// that it judges (no GJK, no EPA, no growth distance, no support mapping over curved sets).
//
// The signed distance is the maximum of the separation along n, min over b of n.b minus max over a of n.a, over all
// unit vectors n: the distance when positive, minus the least translation that parts the two when negative. Every
// separation, along whatever n, is a lower bound of it. The maximum is sought where it can be:
//   - in overlap, among the normals of the faces of the Minkowski difference: the face normals of both, and the cross
//     products of those edge pairs whose arcs on the Gauss map cross (the separating axes);
//   - apart, as the shortest connection of a vertex with a face or of two edges.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "scene/polyhedron.h"
#include "scene/pose.h"

namespace dgd_demos {

/// A polyhedron in the world, its features spelled out.
struct PosedPolyhedron {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Polyhedron::Face> faces;  ///< Normals in the world.
  const std::vector<Polyhedron::Edge>* edges;

  PosedPolyhedron(const Polyhedron& polyhedron, const Pose& pose);
};

/// min over b of n.b minus max over a of n.a: a lower bound of the signed distance for every unit vector n.
double SeparationAlong(const Eigen::Vector3d& unit, const PosedPolyhedron& a, const PosedPolyhedron& b);

struct SignedDistance {
  double value;            ///< m; negative: the least translation that parts the two.
  Eigen::Vector3d normal;  ///< From a to b, unit; the separation along it is `value` up to rounding.
};

/// Exact up to rounding. For two polyhedra without faces (points, segments) the value is never negative: what has no
/// inside cannot be entered. The normal is any unit vector where the features touch.
SignedDistance ComputeSignedDistance(const PosedPolyhedron& a, const PosedPolyhedron& b);

}  // namespace dgd_demos
