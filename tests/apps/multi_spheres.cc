// Capsules as Bullet's MJCF importer makes them, of two spheres, and pads of four: they come to rest where they land.
#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Part {
  int spheres;    // 0 for a capsule.
  double radius;  // m
  Ground ground;
  int index;
};

btConvexShape& MakePart(Lab& lab, const Part& it) {
  const double reach = 3 * it.radius, aside = it.spheres == 4 ? 2 * it.radius : 0;
  if (it.spheres == 0) return lab.Make<btCapsuleShapeX>(btScalar(it.radius), btScalar(2 * reach));
  const std::array<btVector3, 4> positions = {Vec(-reach, -aside, 0), Vec(reach, -aside, 0), Vec(-reach, aside, 0),
                                              Vec(reach, aside, 0)};
  const btScalar radius = btScalar(it.radius);
  const std::array<btScalar, 4> radii = {radius, radius, radius, radius};
  return lab.Make<btMultiSphereShape>(positions.data(), radii.data(), it.spheres);
}

Case RunPart(const Conditions& conditions, const Part& it) {
  constexpr double kSettleTime = 2.5, kMeasureTime = 0.5;  // s
  Lab lab(conditions);
  lab.AddGround(it.ground);
  const btQuaternion tilt(Vec(0, 1, 0), btScalar(0.05));
  btRigidBody& body =
      lab.AddBody(MakePart(lab, it), 1, At(Vec(0.23, 0.31, 2 * it.radius), Yaw(HeadingOf(it.index)) * tilt),
                  Surface{.friction = 1});
  // Else what lands askew rolls on for ever, which is right.
  body.setRollingFriction(btScalar(0.1 * it.radius));
  lab.Run(kSettleTime);
  const std::string name = it.spheres == 0 ? "capsule" : Text(it.spheres) + " spheres";
  return {NameOf(it.ground),
          name + " of " + Text(it.radius) + " m on " + NameOf(it.ground),
          {1000 * RestSpeed(lab, kMeasureTime, 4 * it.radius)}};
}

std::vector<Part> Parts() {
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh, Ground::kHeightfield};
  std::vector<Part> parts;
  for (const int spheres : {2, 4, 0}) {
    for (const Ground ground : kGrounds) {
      for (const double radius : {0.1, 0.02}) parts.push_back({spheres, radius, ground, int(parts.size())});
    }
  }
  return parts;
}

Cases RunMultiSpheres(const Conditions& conditions) { return RunCases(conditions, Parts(), 1, RunPart); }

}  // namespace

App MultiSpheres() {
  return {"multi_spheres",
          "capsules of two spheres and pads of four lie on the ground: how fast they still move",
          {{"speed at rest, mm/s", Combine::kMean, 0.1, 2, "what moves 2 mm/s falls asleep all the same"}},
          RunMultiSpheres};
}

}  // namespace dgd_apps
