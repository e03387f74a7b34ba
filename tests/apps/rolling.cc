// A ball on the level, as in a game of bowls: nothing slows it, lifts it or turns it aside.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Floor { kBox, kPlane, kTwoTriangles, kCells, kHeightfield };

std::string NameOf(Floor floor) {
  constexpr std::array kNames = {"box", "plane", "two triangles", "mesh", "heightfield"};
  return kNames[static_cast<std::size_t>(floor)];
}

constexpr double kFloorHalf = 45;  // m

void AddFloor(Lab& lab, Floor floor) {
  const Grid whole = {.cells = 2, .pitch = kFloorHalf}, fine = {.cells = 60, .pitch = 1.5, .alternates = true};
  switch (floor) {
    case Floor::kBox:
      lab.AddGround(Ground::kBox, btTransform::getIdentity(), whole);
      break;
    case Floor::kPlane:
      lab.AddGround(Ground::kPlane);
      break;
    case Floor::kTwoTriangles: {
      auto& mesh = lab.Make<btTriangleMesh>();
      const double h = kFloorHalf;
      mesh.addTriangle(Vec(-h, -h, 0), Vec(h, -h, 0), Vec(h, h, 0));
      mesh.addTriangle(Vec(-h, -h, 0), Vec(h, h, 0), Vec(-h, h, 0));
      lab.AddStatic(lab.Make<btBvhTriangleMeshShape>(&mesh, true), At(Vec(0, 0, 0)));
      break;
    }
    case Floor::kCells:
      lab.AddGround(Ground::kMesh, btTransform::getIdentity(), fine);
      break;
    case Floor::kHeightfield:
      lab.AddGround(Ground::kHeightfield, btTransform::getIdentity(), fine);
      break;
  }
}

struct Roll {
  Floor floor;
  double radius, speed;  // m, m/s
  double seconds;
  int index;
};

std::vector<Roll> Rolls(const Conditions& conditions) {
  constexpr std::array<double, 5> kSpeeds = {1.5, 0.2, 5, 0.5, 15};
  constexpr std::array<double, 3> kRadii = {0.5, 0.05, 0.15};
  constexpr double kLongest = 40;  // m
  std::vector<Roll> rolls;
  for (int i = 0; i < 75; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const double speed = kSpeeds[(j / 5) % 5];
    const double seconds = std::min(conditions.is_quick ? 2.0 : 10.0, kLongest / speed);
    rolls.push_back({static_cast<Floor>(i % 5), kRadii[(j + j / 25) % 3], speed, seconds, i});
  }
  return rolls;
}

Case RunRoll(const Conditions& conditions, const Roll& it) {
  Lab lab(conditions);
  AddFloor(lab, it.floor);
  const double heading = HeadingOf(it.index + it.index / 5);
  const btVector3 start = Direction(heading) * btScalar(-0.5 * it.speed * it.seconds) + Vec(0.23, 0.31, it.radius);
  btRigidBody& body = lab.AddBody(lab.Make<btSphereShape>(btScalar(it.radius)), 1, At(start), Surface{.friction = 1});
  lab.Run(0.2);
  body.setLinearVelocity(Direction(heading) * btScalar(it.speed));
  body.setAngularVelocity(Direction(heading + kPi / 2) * btScalar(it.speed / it.radius));
  const double height = HeightOf(body);
  double ripple = 0;
  for (int step = lab.StepsIn(it.seconds); step > 0; --step) {
    lab.Step();
    ripple = std::max(ripple, std::abs(HeightOf(body) - height));
  }
  const btVector3 velocity = body.getLinearVelocity();
  return {NameOf(it.floor),
          "ball " + Text(it.radius) + " m, " + Text(it.speed) + " m/s on " + NameOf(it.floor),
          {std::abs(Along(velocity, heading) / it.speed - 1), std::abs(Along(velocity, heading + kPi / 2)) / it.speed,
           1000 * ripple}};
}

Cases RunRolling(const Conditions& conditions) { return RunCases(conditions, Rolls(conditions), 2, RunRoll); }

}  // namespace

App Rolling() {
  return {"rolling",
          "a ball rolls on boxes, planes, meshes and heightfields at five speeds: what changes in its motion",
          {{"change of the speed, share", Combine::kMean, 0.1, 0.002, "a player sees percents"},
           {"speed aside, share", Combine::kMean, 0.1, 0.002, "the same"},
           {"ripple, mm", Combine::kWorst, 0.1, 0.2, "a fifth of a millimetre is roundoff on 45 m of ground in float"}},
          RunRolling};
}

}  // namespace dgd_apps
