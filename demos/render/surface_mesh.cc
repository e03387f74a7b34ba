#include "render/surface_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/shortest_turn.h"
#include "scene/overloaded.h"

namespace dgd_demos {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kBevelSteps = 2;  // Strips along a rounded edge.
constexpr int kMeridians = 64;  // Of a surface of revolution.
constexpr int kArcSteps = 16;   // Of a half circle in its profile.
constexpr double kPi = std::numbers::pi;

class MeshBuilder {
 public:
  void AddTriangle(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
    // The callers know the corners, not their sense: the normals tell which side is outside.
    const Eigen::Vector3f facing = (b.position - a.position).cross(c.position - a.position);
    const bool outward = facing.dot(a.normal + b.normal + c.normal) >= 0;
    mesh_.insert(mesh_.end(), {a, outward ? b : c, outward ? c : b});
  }
  void AddQuad(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c, const SurfaceVertex& d) {
    AddTriangle(a, b, c);
    AddTriangle(a, c, d);
  }
  SurfaceMesh Take() { return std::move(mesh_); }

 private:
  SurfaceMesh mesh_;
};

SurfaceVertex Offset(const Vector3d& core_point, const Vector3d& normal, double radius) {
  return {(core_point + radius * normal).cast<float>(), normal.cast<float>()};
}

// Unit vectors from `start` to `end`, evenly along the arc between them.
std::vector<Vector3d> Arc(const Vector3d& start, const Vector3d& end) {
  std::vector<Vector3d> arc;
  const Eigen::AngleAxisd turn = ShortestTurn(start, end);
  for (int i = 0; i <= kBevelSteps; ++i) {
    arc.push_back(Eigen::AngleAxisd(turn.angle() * i / kBevelSteps, turn.axis()) * start);
  }
  return arc;
}

// A rounded corner: the part of the sphere around a vertex between the normals of the faces that meet there, as a fan
// around their mean. The arcs between neighbouring faces are those of the bevels, so that no gap opens.
void AddCorner(const Vector3d& vertex, const std::vector<std::vector<Vector3d>>& arcs, double radius,
               MeshBuilder& mesh) {
  Vector3d mean = Vector3d::Zero();
  for (const std::vector<Vector3d>& arc : arcs) mean += arc.front() + arc.back();
  mean.normalize();
  for (const std::vector<Vector3d>& arc : arcs) {
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      mesh.AddTriangle(Offset(vertex, mean, radius), Offset(vertex, arc[i], radius),
                       Offset(vertex, arc[i + 1], radius));
    }
  }
}

// Outline of a revolved, rounded profile: points with normals, in (distance from z, height).
struct ProfilePoint {
  Vector2d position, normal;
};

std::vector<ProfilePoint> RoundProfile(const std::vector<Vector2d>& corners, double radius) {
  // Angle of the outward normal, from -90 degrees at the lower pole to 90 at the upper one.
  const auto edge_angle = [&](std::size_t i) {
    const Vector2d along = corners[i + 1] - corners[i];
    return std::atan2(-along.x(), along.y());
  };
  std::vector<ProfilePoint> outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    // Around a corner, the normal turns from the edge before to the edge after; at the axis, from and to the pole.
    const double start = i == 0 ? -kPi / 2 : edge_angle(i - 1);
    const double end = i + 1 == corners.size() ? kPi / 2 : edge_angle(i);
    const int steps = std::max(1, static_cast<int>(std::ceil(kArcSteps * (end - start) / kPi)));
    for (int s = 0; s <= steps; ++s) {
      const double angle = start + (end - start) * s / steps;
      const Vector2d normal(std::cos(angle), std::sin(angle));
      outline.push_back({corners[i] + radius * normal, normal});
    }
  }
  return outline;
}

SurfaceVertex Revolve(const ProfilePoint& point, int meridian) {
  const double angle = 2 * kPi * meridian / kMeridians;
  const auto turned = [&](const Vector2d& v) {
    return Eigen::Vector3f(Vector3d(v.x() * std::cos(angle), v.x() * std::sin(angle), v.y()).cast<float>());
  };
  return {turned(point.position), turned(point.normal)};
}

}  // namespace

SurfaceMesh RoundedPolyhedronSurface(const Polyhedron& core, double radius) {
  MeshBuilder mesh;
  for (const Polyhedron::Face& face : core.faces) {
    const auto corner = [&](std::size_t i) { return Offset(core.vertices[face.vertices[i]], face.normal, radius); };
    mesh.AddTriangle(corner(0), corner(1), corner(2));
  }
  if (radius == 0) return mesh.Take();

  std::vector<std::vector<std::vector<Vector3d>>> arcs_at(core.vertices.size());
  for (const Polyhedron::Edge& edge : core.edges) {
    const std::vector<Vector3d> arc = Arc(core.faces[edge.faces[0]].normal, core.faces[edge.faces[1]].normal);
    const Vector3d& start = core.vertices[edge.vertices[0]];
    const Vector3d& end = core.vertices[edge.vertices[1]];
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      mesh.AddQuad(Offset(start, arc[i], radius), Offset(start, arc[i + 1], radius), Offset(end, arc[i + 1], radius),
                   Offset(end, arc[i], radius));
    }
    for (const int v : edge.vertices) arcs_at[v].push_back(arc);
  }
  for (std::size_t v = 0; v < core.vertices.size(); ++v) {
    if (!arcs_at[v].empty()) AddCorner(core.vertices[v], arcs_at[v], radius, mesh);
  }
  return mesh.Take();
}

SurfaceMesh RoundedRevolutionSurface(const std::vector<Vector2d>& profile, double radius) {
  const std::vector<ProfilePoint> outline = RoundProfile(profile, radius);
  MeshBuilder mesh;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    for (int m = 0; m < kMeridians; ++m) {
      mesh.AddQuad(Revolve(outline[i], m), Revolve(outline[i], m + 1), Revolve(outline[i + 1], m + 1),
                   Revolve(outline[i + 1], m));
    }
  }
  return mesh.Take();
}

SurfaceMesh TwoSidedSurface(const std::vector<Vector3d>& corners) {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vector3d &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
    const Vector3d normal = (b - a).cross(c - a).normalized();
    if (!(normal.squaredNorm() > 0)) continue;
    mesh.insert(mesh.end(), {Offset(a, normal, 0), Offset(b, normal, 0), Offset(c, normal, 0)});
    mesh.insert(mesh.end(), {Offset(a, -normal, 0), Offset(c, -normal, 0), Offset(b, -normal, 0)});
  }
  return mesh;
}

void Append(const SurfaceMesh& part, const Pose& pose, SurfaceMesh& mesh) {
  for (const SurfaceVertex& vertex : part) {
    const Vector3d position = pose * vertex.position.cast<double>();
    mesh.push_back(Offset(position, pose.rotation * vertex.normal.cast<double>(), 0));
  }
}

double BoundingRadius(const SurfaceMesh& mesh) {
  float radius = 0;
  for (const SurfaceVertex& vertex : mesh) radius = std::max(radius, vertex.position.norm());
  return double(radius);
}

SurfaceMesh SurfaceOf(const Shape& shape, double margin) {
  const double radius = RoundingRadius(shape, margin);
  return std::visit(
      Overloaded{[=](const Sphere&) {
                   return RoundedRevolutionSurface({{0, 0}}, radius);
                 },
                 [=](const Capsule& capsule) {
                   return RoundedRevolutionSurface({{0, -capsule.length / 2}, {0, capsule.length / 2}}, radius);
                 },
                 [=](const Cylinder& cylinder) {
                   const double r = cylinder.radius - radius, h = cylinder.height / 2 - radius;
                   return RoundedRevolutionSurface({{0, -h}, {r, -h}, {r, h}, {0, h}}, radius);
                 },
                 [=](const Cone& cone) {
                   return RoundedRevolutionSurface(
                       {{0, -cone.height / 2}, {cone.radius, -cone.height / 2}, {0, cone.height / 2}}, radius);
                 },
                 [&](const auto& polyhedral) { return RoundedPolyhedronSurface(CoreOf(polyhedral, margin), radius); }},
      shape);
}

}  // namespace dgd_demos
