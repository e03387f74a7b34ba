#include "scene/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/overloaded.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr double kSafeMarginShare = 0.1;     // Bullet's setSafeMargin: of the least half extent.
constexpr double kBoxEdgeShare = 1.0 / 512;  // dgd_bullet::GeometryMode: of the least half extent.

double SafeMargin(double least_half_extent, double margin) {
  return std::min(margin, kSafeMarginShare * least_half_extent);
}

void AppendCircle(double radius, double z, std::vector<Vector3d>& points) {
  for (int i = 0; i < kCircleSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCircleSides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

Polyhedron BoxCore(const Vector3d& half_extents) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d signs((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    corners.push_back(signs.cwiseProduct(half_extents));
  }
  return ConvexHull(corners);
}

Polyhedron CylinderCore(double radius, double half_height) {
  std::vector<Vector3d> points;
  AppendCircle(radius, -half_height, points);
  AppendCircle(radius, half_height, points);
  return ConvexHull(points);
}

Polyhedron ConeCore(const Cone& cone) {
  std::vector<Vector3d> points = {Vector3d(0, 0, cone.height / 2)};
  AppendCircle(cone.radius, -cone.height / 2, points);
  return ConvexHull(points);
}

}  // namespace

double BulletMargin(const Shape& shape, double margin) {
  return std::visit(
      Overloaded{
          [](const Sphere& sphere) { return sphere.radius; }, [](const Capsule& capsule) { return capsule.radius; },
          [=](const Box& box) { return SafeMargin(box.half_extents.minCoeff(), margin); },
          [=](const Cylinder& cylinder) { return SafeMargin(std::min(cylinder.radius, cylinder.height / 2), margin); },
          [=](const Cone&) { return margin; }, [=](const Hull&) { return margin; }},
      shape);
}

double RoundingRadius(const Shape& shape, double margin) {
  const auto* box = std::get_if<Box>(&shape);
  if (box == nullptr) return BulletMargin(shape, margin);
  return std::min(margin, kBoxEdgeShare * box->half_extents.minCoeff());
}

Polyhedron CoreOf(const Shape& shape, double margin) {
  const double radius = RoundingRadius(shape, margin);
  return std::visit(
      Overloaded{[](const Sphere&) { return PointPolyhedron(); },
                 [](const Capsule& capsule) { return SegmentPolyhedron(capsule.length / 2); },
                 [=](const Box& box) { return BoxCore(box.half_extents.array() - radius); },
                 [=](const Cylinder& cylinder) {
                   return CylinderCore(cylinder.radius - radius, cylinder.height / 2 - radius);
                 },
                 [](const Cone& cone) { return ConeCore(cone); }, [](const Hull& hull) { return hull.polyhedron; }},
      shape);
}

double BoundingRadius(const Shape& shape, double margin) {
  return BoundingRadius(CoreOf(shape, margin)) + RoundingRadius(shape, margin);
}

}  // namespace dgd_demos
