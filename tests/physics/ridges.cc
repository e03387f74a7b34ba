// Bodies that fly over a ridge, level or spinning, and clear it: nothing happens to them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/lab.h"
#include "physics/near_miss.h"

namespace dgd_physics {
namespace {

enum class Ridge { kBox, kHull, kMesh };

std::string NameOf(Ridge ridge) {
  constexpr std::array kNames = {"box", "hull", "mesh"};
  return kNames[static_cast<std::size_t>(ridge)];
}

struct Flight {
  Form form;
  double half, clearance, speed;  // m, m/s
  double yaw;                     // rad
  double spin;                    // rad/s
  Ridge ridge;
  double near_side, far_side;  // Below the horizontal, rad; a box's are 45 degrees.
  int index;
};

/// Forms, gaps and speeds change at different paces.
Flight FlightOf(int index, Ridge ridge) {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kBox, Form::kCylinder};
  constexpr std::array<double, 5> kClearances = {0.002, 0.0005, 0.008, 0.001, 0.02};
  constexpr std::array<double, 4> kSpeeds = {1.5, 4, 10, 0.7};
  constexpr std::array<double, 5> kDegrees = {30, 10, 60, 45, 80};
  constexpr std::array<double, 3> kHalves = {0.1, 0.25, 0.05};
  const std::size_t i = static_cast<std::size_t>(index);
  return {kForms[i % 4],
          kHalves[(i + i / 3) % 3],
          kClearances[(i + i / 5) % 5],
          kSpeeds[(i + i / 4) % 4],
          i % 3 == 2 ? 0.4 : 0,
          0,
          ridge,
          kDegrees[i % 5] * kPi / 180,
          (i / 5 % 2 == 0 ? 10 : 80) * kPi / 180,
          index};
}

std::vector<Flight> FlightCases() {
  std::vector<Flight> cases;
  for (int i = 0; i < 90; ++i) cases.push_back(FlightOf(i / 3, static_cast<Ridge>(i % 3)));
  constexpr std::array<double, 4> kSpins = {12, 5, 25, 40};  // rad/s
  for (int i = 0; i < 60; ++i) {
    Flight flight = FlightOf(i, static_cast<Ridge>(i / 2 % 3));
    flight.spin = kSpins[static_cast<std::size_t>(i + i / 4) % 4];
    if (flight.half > 0.2) flight.spin *= 0.4;
    cases.push_back(flight);
  }
  return cases;
}

/// The frame's y axis is its highest line; it falls towards -x on the near side.
void AddRidge(Lab& lab, const Flight& it, const btTransform& frame) {
  constexpr double kHalfLength = 1, kMargin = 0.0005;  // m
  constexpr Surface kSurface = {.friction = 0.5, .restitution = 1};
  if (it.ridge == Ridge::kBox) {
    constexpr double kHalf = 0.3;  // m
    const btTransform pose = At(Vec(0, 0, -kHalf * std::sqrt(2.0)), btQuaternion(Vec(0, 1, 0), btScalar(kPi / 4)));
    lab.AddStatic(lab.Make<btBoxShape>(Vec(kHalf, kHalfLength, kHalf)), frame * pose, kSurface);
    return;
  }
  const auto corner = [&it](int side, double y) {
    const double angle = side < 0 ? it.near_side : it.far_side;
    return side == 0 ? Vec(0, y, 0) : Vec(side * std::cos(angle), y, -std::sin(angle));
  };
  btCollisionShape* shape = nullptr;
  if (it.ridge == Ridge::kHull) {
    auto& hull = lab.Make<btConvexHullShape>();
    for (const int side : {-1, 0, 1}) {
      for (const double y : {-kHalfLength, kHalfLength}) hull.addPoint(corner(side, y));
    }
    shape = &hull;
  } else {
    auto& triangles = lab.Make<btTriangleMesh>();
    for (const int side : {-1, 1}) {
      const btVector3 top[] = {corner(0, -kHalfLength), corner(0, kHalfLength)};
      const btVector3 low[] = {corner(side, -kHalfLength), corner(side, kHalfLength)};
      triangles.addTriangle(top[side < 0 ? 0 : 1], top[side < 0 ? 1 : 0], low[side < 0 ? 1 : 0]);
      triangles.addTriangle(top[0], low[side < 0 ? 1 : 0], low[side < 0 ? 0 : 1]);
    }
    shape = &lab.Make<btBvhTriangleMeshShape>(&triangles, true);
  }
  shape->setMargin(btScalar(kMargin));
  lab.AddStatic(*shape, frame * At(Vec(0, 0, -kMargin)), kSurface);
}

/// How far a spinning body reaches down at most while any of it is above the ridge.
/// @param arrival  When its centre is, s.
double LowestReach(const btConvexShape& shape, const btQuaternion& start, const btVector3& spin, double arrival,
                   double speed) {
  constexpr int kMoments = 2000;
  double radius = 0, reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    btVector3 direction(0, 0, 0);
    direction[axis] = 1;
    radius = std::hypot(radius, ExtentOf(shape, direction));
  }
  for (int i = 0; i <= kMoments; ++i) {
    const double time = arrival + (2.0 * i / kMoments - 1) * radius / speed;
    const double angle = double(spin.length()) * time;
    const btQuaternion rotation = angle == 0 ? start : btQuaternion(spin.normalized(), btScalar(angle)) * start;
    reach = std::max(reach, ExtentOf(shape, quatRotate(rotation.inverse(), Vec(0, 0, -1))));
  }
  return reach;
}

/// The plane through the ridge and along the way parts the two.
Sample MeasureFlight(const Conditions& conditions, const Flight& it) {
  constexpr double kRange = 1;  // m
  Lab lab(conditions, 0);
  // All of it is turned, so that bounding boxes do not part the two.
  const btQuaternion turn(Vec(0.48, 0.64, 0.6), btScalar(0.6 + it.index % 3));
  const btTransform frame = At(Vec(0, 0, 0), turn);
  AddRidge(lab, it, frame);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double distance = kRange + it.speed * lab.dt() * PhaseOf(it.index);
  // About the shortest side or a box's longest, which is steady.
  const btVector3 axis = it.index % 8 == 2 ? Vec(1, 0, 0) : Vec(0, 0, 1);
  btQuaternion rotation = Yaw(it.yaw);
  if (it.spin > 0) rotation = btQuaternion(Vec(0, 1, 0), btScalar(1.1 + it.index)) * rotation;
  const btVector3 spin = quatRotate(rotation, axis) * btScalar(it.spin);
  const double height = LowestReach(shape, rotation, spin, distance / it.speed, it.speed) + it.clearance;
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(Vec(-distance, 0.05, height), rotation),
                                  Surface{.friction = 0.5, .restitution = 0.3 + 0.7 * (it.index % 2)});
  const btVector3 velocity = quatRotate(turn, Vec(it.speed, 0, 0));
  body.setLinearVelocity(velocity);
  body.setAngularVelocity(quatRotate(turn, spin));
  lab.Run(2 * distance / it.speed);
  return {NameOf(it.form) + " " + Text(it.half) + " m over " + NameOf(it.ridge) + ", sides " + Text(it.near_side) +
              " and " + Text(it.far_side) + " rad, " + Text(it.clearance) + " m clear, " + Text(it.speed) + " m/s, " +
              Text(it.spin) + " rad/s",
          DisturbanceOf(body, velocity, quatRotate(turn, spin), it.half) / it.speed, 0, 1,
          it.spin > 0 ? "spinning" : NameOf(it.ridge)};
}

}  // namespace

Samples MeasureOverRidge(const Conditions& conditions) {
  return MeasureCases(conditions, FlightCases(), 11,
                      [](const Conditions& under, const Flight& it) { return MeasureFlight(under, it); });
}

}  // namespace dgd_physics
