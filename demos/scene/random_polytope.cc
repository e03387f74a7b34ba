#include "scene/random_polytope.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr double kLeastSemiAxis = 0.8;  // Of the ellipsoid; the longest is 1.
// Least distance of two vertices on the unit sphere. Twenty points then forbid each other about a seventh of it.
double LeastSpacing(int vertices) { return 1 / std::sqrt(vertices); }
// Least distance from the centre of mass to a face, as a share of the diameter. A regular tetrahedron has 0.20.
constexpr double kLeastInradius = 0.1;

bool KeepsDistance(const Vector3d& point, const std::vector<Vector3d>& others, double distance) {
  return std::ranges::all_of(others, [&](const Vector3d& other) { return (other - point).norm() >= distance; });
}

std::vector<Vector3d> PointsOnSphere(Random& random, int count) {
  std::vector<Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    const Vector3d point = random.UnitVector();
    if (KeepsDistance(point, points, LeastSpacing(count))) points.push_back(point);
  }
  return points;
}

double Diameter(const std::vector<Vector3d>& points) {
  double diameter = 0;
  for (const Vector3d& a : points) {
    for (const Vector3d& b : points) diameter = std::max(diameter, (a - b).norm());
  }
  return diameter;
}

}  // namespace

Polyhedron RandomPolytope(Random& random, int vertices, double diameter) {
  while (true) {
    std::vector<Vector3d> points = PointsOnSphere(random, vertices);
    const Vector3d semi_axes = random.InBox(Vector3d::Constant(kLeastSemiAxis), Vector3d::Ones());
    for (Vector3d& point : points) point = point.cwiseProduct(semi_axes);

    const double scale = diameter / Diameter(points);
    for (Vector3d& point : points) point *= scale;

    Polyhedron polytope = ConvexHull(points);
    const Vector3d centre_of_mass = Centroid(polytope);
    for (Vector3d& vertex : polytope.vertices) vertex -= centre_of_mass;

    const bool all_are_vertices = static_cast<int>(polytope.vertices.size()) == vertices;
    const bool is_round = DistanceToBoundary(polytope, Vector3d::Zero()) >= kLeastInradius * diameter;
    if (all_are_vertices && is_round) return polytope;
  }
}

}  // namespace dgd_demos
