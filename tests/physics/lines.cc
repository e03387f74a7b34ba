// Bodies that come down flat on a line: a plank across a bar, a roller on its side. By symmetry the impulse passes
// through the middle of the line, and nothing rolls sideways over an end of it.
#include <cmath>
#include <vector>

#include "physics/edges.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

enum class Bar { kBox, kCylinder, kCapsule, kBoxEdge, kHullEdge, kMeshWall, kMeshRoof, kFloor };

std::string NameOf(Bar bar) {
  constexpr std::array kNames = {
      "box", "cylinder", "capsule", "edge of a box", "edge of a hull", "wall of a mesh", "roof of a mesh", "floor"};
  return kNames[static_cast<std::size_t>(bar)];
}

std::string GroupOf(Bar bar) {
  if (bar == Bar::kFloor) return "rollers";
  if (bar == Bar::kMeshWall || bar == Bar::kMeshRoof) return "mesh edges";
  return bar == Bar::kBoxEdge || bar == Bar::kHullEdge ? "edges" : "bars";
}

/// Its highest line is the frame's y axis.
void AddBar(Lab& lab, Bar bar, const btTransform& frame) {
  constexpr double kHalfLength = 1, kSize = 0.3, kMargin = 0.001;  // m
  constexpr Surface kSurface = {.friction = 0, .restitution = 1};
  const auto add = [&](btCollisionShape& shape, double depth, const btQuaternion& turn = btQuaternion::getIdentity()) {
    lab.AddStatic(shape, frame * At(Vec(0, 0, -depth), turn), kSurface);
  };
  const auto corner = [](double x, double y, double z) { return Vec(x, y * kHalfLength, z); };
  switch (bar) {
    case Bar::kBox:
      return add(lab.Make<btBoxShape>(Vec(0.02, kHalfLength, kSize)), kSize);
    case Bar::kCylinder:
      return add(lab.Make<btCylinderShape>(Vec(0.05, kHalfLength, 0.05)), 0.05);
    case Bar::kCapsule:
      return add(lab.Make<btCapsuleShape>(btScalar(0.01), btScalar(2 * kHalfLength)), 0.01);
    case Bar::kBoxEdge:
      return add(lab.Make<btBoxShape>(Vec(kSize, kHalfLength, kSize)), kSize * std::sqrt(2.0),
                 btQuaternion(Vec(0, 1, 0), btScalar(kPi / 4)));
    case Bar::kFloor:
      return add(lab.Make<btBoxShape>(Vec(kHalfLength, kHalfLength, kSize)), kSize);
    default:
      break;
  }
  if (bar == Bar::kHullEdge) {
    auto& hull = lab.Make<btConvexHullShape>();
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-kSize, 0.0, kSize}) hull.addPoint(corner(x, y, x == 0 ? 0 : -kSize));
    }
    hull.setMargin(btScalar(kMargin));
    return add(hull, kMargin);
  }
  auto& triangles = lab.Make<btTriangleMesh>();
  const auto add_side = [&](double x) {
    triangles.addTriangle(corner(0, -1, 0), corner(0, 1, 0), corner(x, 1, -0.5));
    triangles.addTriangle(corner(0, -1, 0), corner(x, 1, -0.5), corner(x, -1, -0.5));
  };
  if (bar == Bar::kMeshWall) {
    add_side(0);
  } else {
    for (const double x : {-0.5, 0.5}) add_side(x);
  }
  auto& mesh = lab.Make<btBvhTriangleMeshShape>(&triangles, true);
  mesh.setMargin(btScalar(kMargin));
  add(mesh, kMargin);
}

struct Line {
  Bar bar;
  bool is_hull;       // The plank, in place of a box.
  double half;        // Half the line's length, m.
  double off_middle;  // Of the bar from the plank's middle, m.
  int index;
};

std::vector<Line> LineCases() {
  constexpr std::array kBars = {Bar::kBox,     Bar::kMeshWall, Bar::kBoxEdge,  Bar::kFloor,
                                Bar::kCapsule, Bar::kMeshRoof, Bar::kHullEdge, Bar::kCylinder};
  constexpr std::array<double, 5> kHalves = {0.0025, 0.01, 0.05, 0.005, 0.02};  // m
  std::vector<Line> cases;
  for (int i = 0; i < 48; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kBars[j % 8], j / 8 % 2 == 1, kHalves[(j + j / 8) % 5], j / 16 == 1 ? 0.1 : 0, i});
  }
  return cases;
}

/// Across the bar, along x; or a roller along y. Both thin.
btConvexShape& MakePlank(Lab& lab, const Line& it) {
  constexpr double kHalfLength = 0.4, kHalfThickness = 0.02;  // m
  if (it.bar == Bar::kFloor) return lab.Make<btCylinderShape>(Vec(0.6 * it.half, it.half, 0.6 * it.half));
  if (!it.is_hull) return lab.Make<btBoxShape>(Vec(kHalfLength, it.half, kHalfThickness));
  const double margin = 0.1 * it.half;
  auto& hull = lab.Make<btConvexHullShape>();
  for (int i = 0; i < 8; ++i) {
    hull.addPoint(Vec((i % 2 == 0 ? -1 : 1) * (kHalfLength - margin), (i / 2 % 2 == 0 ? -1 : 1) * (it.half - margin),
                      (i / 4 == 0 ? -1 : 1) * (kHalfThickness - margin)));
  }
  hull.setMargin(btScalar(margin));
  return hull;
}

/// Speed at an end of the line, by rotation about the plank's length, three steps after the impact; over that of the
/// drop.
Sample MeasureLine(const Conditions& conditions, const Line& it) {
  constexpr double kSpeed = 2, kGap = 0.3;  // m/s, m
  Lab lab(conditions, 0);
  const double heading = HeadingOf(it.index);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(heading));
  AddBar(lab, it.bar, frame * At(Vec(it.off_middle, 0, 0)));
  btConvexShape& shape = MakePlank(lab, it);
  const double gap = kGap + PhaseOf(it.index) * kSpeed * lab.dt();
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(Vec(0, 0.05 * (it.index % 3), FootOf(shape) + gap)),
                                  Surface{.friction = 0, .restitution = 0.5});
  body.setLinearVelocity(Vec(0, 0, -kSpeed));
  lab.Run(gap / kSpeed + 3 * lab.dt());
  const double roll = std::abs(Along(body.getAngularVelocity(), heading)) * it.half;
  return {(it.bar == Bar::kFloor ? std::string("roller")
           : it.is_hull          ? "hull"
                                 : "plank") +
              " of " + Text(2 * it.half) + " m on " + NameOf(it.bar) + ", off the middle by " + Text(it.off_middle) +
              " m",
          roll / kSpeed, 0, 1, GroupOf(it.bar)};
}

}  // namespace

Samples MeasureLines(const Conditions& conditions) {
  return MeasureCases(conditions, LineCases(), 5,
                      [](const Conditions& under, const Line& it) { return MeasureLine(under, it); });
}

}  // namespace dgd_physics
