// Small boxes on floors of large ones, which are as sharp as small ones: at a ledge a box stands if its centre is over
// the floor, and falls if it is not; over the seam of two flush floors it lies and slides as in their middle.
#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/edges.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

struct LargeBox {
  double size;  // Of the floor, m.
  double half;  // Of the box on it, m.
  bool is_hull;
  int index;

  std::string Name() const {
    return std::string(is_hull ? "hull" : "box") + " of " + Text(2 * half) + " m on a box of " + Text(size) + " m";
  }
};

std::vector<LargeBox> LargeBoxCases() {
  constexpr std::array<double, 5> kSizes = {20, 2, 100, 5, 50};        // m
  constexpr std::array<double, 4> kHalves = {0.02, 0.01, 0.25, 0.05};  // m
  std::vector<LargeBox> cases;
  for (int i = 0; i < 20; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kSizes[j % 5], kHalves[j % 4], i % 5 == 4, i});
  }
  return cases;
}

constexpr Surface kSlippery = {.friction = 0, .restitution = 0};

/// A floor that ends at x = 0 of the frame, above it or below; its top is z = 0.
void AddFloor(Lab& lab, const LargeBox& it, const btTransform& frame, double side, Surface surface) {
  const double half = it.size / 2;
  lab.AddStatic(lab.Make<btBoxShape>(Vec(half, half, half)), frame * At(Vec(side * half, 0.1 * half, -half)), surface);
}

btRigidBody& AddSmall(Lab& lab, const LargeBox& it, const btTransform& frame, double x, double yaw, Surface surface) {
  const double margin = 0.05 * it.half;
  btConvexShape& shape =
      it.is_hull
          ? static_cast<btConvexShape&>(lab.MakePrism(4, std::sqrt(2.0) * (it.half - margin), it.half - margin, margin))
          : lab.Make<btBoxShape>(Vec(it.half, it.half, it.half));
  return lab.AddBody(shape, 1, frame * At(Vec(x, 0, it.half), Yaw(yaw)), surface);
}

/// Aligned with the world's axes, or turned.
btTransform FrameOf(const LargeBox& it) { return At(Vec(0, 0, 0), Yaw(it.index % 3 == 2 ? 0.4 : 0)); }

/// Share of boxes that fall though their centre is over the ledge, or stay though it is not.
Sample MeasureLargeLedge(const Conditions& conditions, const LargeBox& it) {
  constexpr double kDuration = 3;  // s
  int wrong = 0, count = 0;
  for (const double offset : {-0.0005, 0.0005, -0.002, 0.002, -0.006, 0.006}) {  // m
    if (conditions.is_quick && std::abs(offset) > 0.001) continue;
    Lab lab(conditions);
    const btTransform frame = FrameOf(it);
    AddFloor(lab, it, frame, -1, Surface{.friction = 1, .restitution = 0});
    const btRigidBody& body = AddSmall(lab, it, frame, offset, 0, Surface{.friction = 1, .restitution = 0});
    lab.Run(kDuration);
    const bool has_fallen = HeightOf(body) < 0.8 * it.half;
    if (has_fallen != (offset > 0)) ++wrong;
    ++count;
  }
  return {it.Name() + ", at its edge: wrong falls", wrong / double(count), 0, 1, "ledges"};
}

/// How far a box sinks in that is put down on a seam, over its half size; and the speed that it has lost beyond one.
Samples MeasureLargeSeam(const Conditions& conditions, const LargeBox& it) {
  constexpr double kSinkTime = 1, kSpeed = 0.9;  // s, m/s
  const auto on_seam = [&](double x, double speed, double seconds, const auto& measure) {
    Lab lab(conditions);
    const btTransform frame = FrameOf(it);
    for (const double side : {-1.0, 1.0}) AddFloor(lab, it, frame, side, kSlippery);
    btRigidBody& body = AddSmall(lab, it, frame, x, it.index % 2 == 0 ? 0 : 0.3, kSlippery);
    const btVector3 along = frame.getBasis().getColumn(0);
    body.setLinearVelocity(along * btScalar(speed));
    lab.Run(seconds);
    return measure(body, along);
  };
  const double start = 2 * it.half + 0.02 * PhaseOf(it.index);
  const double sunk = on_seam(0, 0, kSinkTime, [&](const btRigidBody& body, const btVector3&) {
    return std::abs(it.half - HeightOf(body)) / it.half;
  });
  const double kept = on_seam(-start, kSpeed, 2 * start / kSpeed, [&](const btRigidBody& body, const btVector3& along) {
    return double(body.getLinearVelocity().dot(along)) / kSpeed;
  });
  return {Sample{it.Name() + ", on a seam of two: sunk, over the half size", sunk, 0, 1, "seams"},
          RelativeToTheory(it.Name() + ", over a seam of two: speed kept", kept, 1, "seams")};
}

}  // namespace

Samples MeasureLargeBoxes(const Conditions& conditions) {
  Samples samples;
  for (const LargeBox& it : SelectCases(conditions, LargeBoxCases(), 6)) {
    samples.push_back(MeasureLargeLedge(conditions, it));
    AddTo(samples, MeasureLargeSeam(conditions, it));
  }
  return samples;
}

}  // namespace dgd_physics
