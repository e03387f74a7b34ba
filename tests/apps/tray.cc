// Bin picking: parts of 1 to 5 cm, with Bullet's default margins, are dropped into a tray and must lie in it.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Part { kCube, kNut, kWasher, kScrew, kPill, kCone };
constexpr std::array kParts = {Part::kCube, Part::kNut, Part::kWasher, Part::kScrew, Part::kPill, Part::kCone};

std::string NameOf(Part part) {
  constexpr std::array kNames = {"cubes", "nuts", "washers", "screws", "pills", "cones"};
  return kNames[static_cast<std::size_t>(part)];
}

btCollisionShape& MakePart(Lab& lab, Part part, double size) {
  const double radius = size / 2;
  switch (part) {
    case Part::kCube:
      return MakeCube(lab, radius);
    case Part::kNut:
      return lab.MakePrism(6, radius, 0.4 * radius, 0.02 * size);
    case Part::kWasher:
      return lab.Make<btCylinderShapeZ>(Vec(radius, radius, 0.15 * radius));
    case Part::kPill:
      return lab.Make<btCapsuleShapeZ>(btScalar(0.3 * radius), btScalar(1.2 * radius));
    case Part::kCone: {
      auto& cone = lab.Make<btConeShapeZ>(btScalar(0.6 * radius), btScalar(1.2 * radius));
      cone.setMargin(btScalar(0.02 * size));  // The default of 4 cm is on top of the size.
      return cone;
    }
    default:
      break;
  }
  auto& screw = lab.Make<btCompoundShape>();
  screw.addChildShape(At(Vec(0, 0, -0.3 * radius)),
                      &lab.Make<btCylinderShapeZ>(Vec(0.25 * radius, 0.25 * radius, radius)));
  screw.addChildShape(At(Vec(0, 0, 0.8 * radius)),
                      &lab.Make<btCylinderShapeZ>(Vec(0.6 * radius, 0.6 * radius, 0.2 * radius)));
  return screw;
}

/// A floor of half the width and four walls around it.
void AddTray(Lab& lab, Ground floor, double half_width, double size) {
  const Grid grid = {.cells = 10, .pitch = (half_width + size) / 5};
  lab.AddGround(floor, btTransform::getIdentity(), grid, {.friction = 1});
  const double half_height = 4 * size, half_wall = size / 2;
  for (int side = 0; side < 4; ++side) {
    auto& wall = lab.Make<btBoxShape>(Vec(half_wall, half_width + size, half_height));
    const btTransform turn = At(Vec(0, 0, 0), Yaw(side * kPi / 2));
    lab.AddStatic(wall, turn * At(Vec(half_width + half_wall, 0, half_height)));
  }
}

struct Drop {
  Part part;
  Ground floor;
  double size;  // m
  int count;
  int index;
};

Case RunDrop(const Conditions& conditions, const Drop& it) {
  constexpr double kFallTime = 1.5, kMeasureTime = 0.3;  // s
  Lab lab(conditions);
  const double half_width = 3 * it.size;
  AddTray(lab, it.floor, half_width, it.size);
  btCollisionShape& shape = MakePart(lab, it.part, it.size);
  std::vector<const btRigidBody*> parts;
  for (int i = 0; i < it.count; ++i) {
    const int phase = i + it.count * it.index;
    const btVector3 axis = Vec(PhaseOf(phase) - 0.5, PhaseOf(2 * phase + 1) - 0.5, 0.3).normalized();
    const btVector3 position = Vec((i % 3 - 1) * 1.3, (i / 3 % 3 - 1) * 1.3, 1.5 + 1.3 * (i / 9)) * btScalar(it.size);
    const btTransform pose = At(position, btQuaternion(axis, btScalar(6 * PhaseOf(3 * phase))));
    parts.push_back(&lab.AddBody(shape, 1000 * it.size * it.size * it.size, pose));
  }
  lab.Run(kFallTime);
  const double speed = RestSpeed(lab, kMeasureTime, it.size / 2);
  const auto is_lost = [&](const btRigidBody* part) {
    const btVector3 p = PositionOf(*part);
    const bool is_in = double(p.z()) > -0.1 * it.size && std::abs(double(p.x())) < half_width + it.size &&
                       std::abs(double(p.y())) < half_width + it.size;
    return !is_in;
  };
  const auto lost = std::ranges::count_if(parts, is_lost);
  return {dgd_physics::NameOf(it.floor),
          NameOf(it.part) + " of " + Text(100 * it.size) + " cm on " + dgd_physics::NameOf(it.floor),
          {double(lost), lost == 0 ? 1000 * speed : 0}};
}

std::vector<Drop> Drops(const Conditions& conditions) {
  std::vector<Drop> drops;
  for (const Part part : kParts) {
    for (const Ground floor : {Ground::kMesh, Ground::kBox, Ground::kHeightfield}) {
      for (const double size : {0.02, 0.01, 0.05})
        drops.push_back({part, floor, size, conditions.is_quick ? 9 : 27, int(drops.size())});
    }
  }
  return drops;
}

Cases RunTray(const Conditions& conditions) { return RunCases(conditions, Drops(conditions), 5, RunDrop); }

}  // namespace

App Tray() {
  return {"tray",
          "small parts are dropped into a tray: lost ones, and how fast those in trays that lost none still move",
          {{"lost parts", Combine::kTotal, 0.1, 1, "where parts fall through, one more or less is chance"},
           {"speed after 1.5 s, mm/s", Combine::kMean, 0.3, 10,
            "parts tumble for a while, and how long is chance; without lost parts, which only fall"}},
          RunTray};
}

}  // namespace dgd_apps
