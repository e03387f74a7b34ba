// Contract: the surface of core + ball, closed and facing outward. Its volume then follows from the divergence theorem,
// and must be what Steiner's formula (or the solid's own) says; a hole, an overlap or a wrong sense would show.
#include "render/surface_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scene/random.h"
#include "scene/random_polytope.h"

namespace dgd_demos {
namespace {

constexpr double kPi = std::numbers::pi;

double EnclosedVolume(const SurfaceMesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.size(); i += 3) {
    const Eigen::Vector3d a = mesh[i].position.cast<double>(), b = mesh[i + 1].position.cast<double>(),
                          c = mesh[i + 2].position.cast<double>();
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

// For a closed surface, the area vectors of its triangles cancel.
double Openness(const SurfaceMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (std::size_t i = 0; i < mesh.size(); i += 3) {
    const Eigen::Vector3f across =
        (mesh[i + 1].position - mesh[i].position).cross(mesh[i + 2].position - mesh[i].position);
    sum += across.cast<double>();
    area += across.norm();
  }
  return sum.norm() / area;
}

void ExpectSurface(const Shape& shape, double margin, double volume, double tolerance) {
  const SurfaceMesh mesh = SurfaceOf(shape, margin);
  EXPECT_NEAR(EnclosedVolume(mesh) / volume, 1, tolerance);
  EXPECT_LT(Openness(mesh), 1e-6);
  for (const SurfaceVertex& vertex : mesh) {
    EXPECT_NEAR(vertex.normal.norm(), 1, 1e-5);
    EXPECT_GT(vertex.normal.dot(vertex.position), 0) << "inward";
  }
}

TEST(SurfaceMeshTest, RoundShapes_HaveTheirVolumes) {
  ExpectSurface(Sphere{0.5}, 0.04, 4 * kPi / 3 * 0.125, 0.02);
  ExpectSurface(Capsule{0.5, 2}, 0.04, 4 * kPi / 3 * 0.125 + kPi * 0.25 * 2, 0.02);
  ExpectSurface(Cylinder{0.5, 1}, 0, kPi * 0.25, 0.01);
  ExpectSurface(Cone{0.5, 1}, 0, kPi * 0.25 / 3, 0.01);
}

// Steiner: volume + area r + mean curvature r^2 + 4/3 pi r^3; for a box, pi/2 times each edge length is the third term.
// Of a hull, which takes a margin that can be seen, and of a box, which takes a 512th of its least half extent.
TEST(SurfaceMeshTest, RoundedBox_HasSteinersVolume) {
  const Eigen::Vector3d half(0.5, 0.6, 0.7);
  for (const bool is_hull : {true, false}) {
    const double r = is_hull ? 0.05 : 0.5 / 512;
    const Eigen::Vector3d core_half = half.array() - r, core = 2 * core_half;
    const double area = 2 * (core.x() * core.y() + core.y() * core.z() + core.z() * core.x());
    const double volume = core.prod() + area * r + kPi * core.sum() * r * r + 4 * kPi / 3 * r * r * r;
    const Shape box = is_hull ? Shape(Hull{CoreOf(Box{core_half}, 0)}) : Shape(Box{half});
    ExpectSurface(box, 0.05, volume, is_hull ? 0.002 : 1e-5);
  }
}

TEST(SurfaceMeshTest, RandomHulls_AreClosedAndGrowByAboutAreaTimesMargin) {
  Random random(51, 0);
  for (int i = 0; i < 20; ++i) {
    const Polyhedron hull = RandomPolytope(random, random.Integer(4, 20), 1);
    const double core = EnclosedVolume(SurfaceOf(Hull{hull}, 0));
    double area = 0;
    for (const Polyhedron::Face& face : hull.faces) {
      const Eigen::Vector3d& a = hull.vertices[face.vertices[0]];
      area += (hull.vertices[face.vertices[1]] - a).cross(hull.vertices[face.vertices[2]] - a).norm() / 2;
    }
    const SurfaceMesh rounded = SurfaceOf(Hull{hull}, 0.04);
    EXPECT_LT(Openness(rounded), 1e-6);
    EXPECT_GT(EnclosedVolume(rounded), core + area * 0.04);
    EXPECT_LT(EnclosedVolume(rounded), core + area * 0.04 + 4 * kPi * 1.0 * 0.04 * 0.04);
  }
}

}  // namespace
}  // namespace dgd_demos
