// Tiles that lie on each other on a slope whose friction holds them: none moves along it.
#include <cmath>
#include <vector>

#include "physics/friction.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

struct Tiles {
  int count;
  double half_side, half_height;  // m
  double slope;                   // rad
  double rows_turn;               // Of each tile against the one below, rad.
  Ground ground;
  int index;
};

std::vector<Tiles> TilesCases() {
  constexpr std::array<std::array<double, 2>, 3> kSizes = {{{0.5, 0.1}, {0.2, 0.02}, {0.3, 0.1}}};  // m
  constexpr std::array<double, 3> kDegrees = {20, 12, 25};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane};
  std::vector<Tiles> cases;
  for (int i = 0; i < 12; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({2 + i % 3, kSizes[(j + j / 3) % 3][0], kSizes[(j + j / 3) % 3][1],
                     kDegrees[(j + j / 2) % 3] * kPi / 180, i % 4 == 3 ? 0.2 : 0, kGrounds[j / 2 % 2], i});
  }
  return cases;
}

/// Way of the topmost in four seconds, over half its side.
Sample MeasureTiles(const Conditions& conditions, const Tiles& it) {
  constexpr double kDuration = 4;  // s
  constexpr Surface kSurface = {.friction = 1, .restitution = 0};
  Lab lab(conditions);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(HeadingOf(it.index)) * btQuaternion(Vec(0, 1, 0), btScalar(it.slope)));
  lab.AddGround(it.ground, frame, {}, kSurface);
  auto& shape = lab.Make<btBoxShape>(Vec(it.half_side, it.half_side, it.half_height));
  std::vector<const btRigidBody*> tiles;
  for (int i = 0; i < it.count; ++i) {
    const btTransform pose = At(Vec(0.23, 0.31, (2 * i + 1) * it.half_height), Yaw(it.rows_turn * i));
    tiles.push_back(&lab.AddBody(shape, 1, frame * pose, kSurface));
  }
  const btRigidBody& top = *tiles.back();
  const btVector3 start = PositionOf(top);
  lab.Run(kDuration);
  const double way = std::abs(double((PositionOf(top) - start).dot(frame.getBasis().getColumn(0))));
  return {Text(it.count) + " tiles of " + Text(2 * it.half_side) + " x " + Text(2 * it.half_height) + " m on " +
              NameOf(it.ground) + ", slope " + Text(it.slope) + ", each turned by " + Text(it.rows_turn) + ": way",
          way / it.half_side, 0, 1, it.rows_turn > 0 ? "turned" : "aligned"};
}

}  // namespace

Samples MeasureTiles(const Conditions& conditions) {
  return MeasureCases(conditions, TilesCases(), 5,
                      [](const Conditions& under, const Tiles& it) { return MeasureTiles(under, it); });
}

}  // namespace dgd_physics
