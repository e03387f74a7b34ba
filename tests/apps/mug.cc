// A mug of hulls, as decomposed meshes are: upright on the table, upside down, lying, and with a spoon's ball in it.
#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

constexpr int kStaves = 10;

/// A floor and staves around it, all convex hulls, as a convex decomposition leaves them. Standing on z = 0.
btCompoundShape& MakeMug(Lab& lab, double radius, double height, double wall, double margin) {
  auto& mug = lab.Make<btCompoundShape>();
  btConvexHullShape& bottom = lab.MakePrism(kStaves, radius - margin, 0.5 * wall - margin, margin);
  mug.addChildShape(At(Vec(0, 0, 0.5 * wall - 0.5 * height)), &bottom);
  for (int i = 0; i < kStaves; ++i) {
    auto& stave = lab.Make<btConvexHullShape>();
    const double from = 2 * kPi * (i + 0.5) / kStaves, to = 2 * kPi * (i + 1.5) / kStaves;
    for (const double angle : {from, to}) {
      for (const double r : {radius - wall + margin, radius - margin}) {
        for (const double z : {margin, height - margin}) {
          stave.addPoint(Direction(angle) * btScalar(r) + Vec(0, 0, z - 0.5 * height), false);
        }
      }
    }
    stave.recalcLocalAabb();
    stave.setMargin(btScalar(margin));
    mug.addChildShape(btTransform::getIdentity(), &stave);
  }
  return mug;
}

struct Stand {
  Ground ground;
  int pose;             // Upright, upside down, lying, tilted so that it rocks upright.
  double size, margin;  // m
  bool has_ball;
  int index;
};

Case RunStand(const Conditions& conditions, const Stand& it) {
  constexpr double kSettleTime = 2.5, kMeasureTime = 0.5;  // s
  constexpr std::array<double, 4> kTurns = {0, kPi, kPi / 2, 0.15};
  constexpr std::array kNames = {"upright", "upside down", "lying", "set down tilted"};
  Lab lab(conditions);
  lab.AddGround(it.ground, btTransform::getIdentity(), {}, Surface{.friction = 0.7});
  const double radius = 0.4 * it.size, height = it.size, wall = 0.1 * it.size;
  const std::size_t pose = static_cast<std::size_t>(it.pose);
  const btQuaternion turn = Yaw(HeadingOf(it.index)) * btQuaternion(Vec(0, 1, 0), btScalar(kTurns[pose]));
  const double centre = (it.pose == 2 ? radius : 0.5 * height) + (it.pose == 3 ? radius * std::sin(0.15) : 0);
  btRigidBody& mug = lab.AddBody(MakeMug(lab, radius, height, wall, it.margin), 0.3, At(Vec(0.23, 0.31, centre), turn));
  if (it.has_ball) {
    auto& ball = lab.Make<btSphereShape>(btScalar(0.2 * it.size));
    lab.AddBody(ball, 0.05, At(Vec(0.23, 0.31, 0.5 * it.size)));
  }
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(mug);
  const double speed = RestSpeed(lab, kMeasureTime, radius);
  const double way = double((PositionOf(mug) - start).length());
  return {kNames[pose],
          std::string(kNames[pose]) + " " + Text(it.size) + " m, margin " + Text(it.margin) + " on " +
              NameOf(it.ground) + (it.has_ball ? ", ball in it" : ""),
          {1000 * speed, 1000 * way}};
}

std::vector<Stand> Stands() {
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh};
  std::vector<Stand> stands;
  for (int i = 0; i < 36; ++i) {
    const int pose = i % 4;
    const double size = (i / 4) % 2 == 0 ? 0.1 : 0.4;
    stands.push_back({kGrounds[static_cast<std::size_t>(i / 4) % 3], pose, size,
                      (i / 12) % 2 == 0 ? 0.001 : 0.02 * size, pose == 0 && i % 8 == 0, i});
  }
  return stands;
}

Cases RunMug(const Conditions& conditions) { return RunCases(conditions, Stands(), 5, RunStand); }

}  // namespace

App Mug() {
  return {"mug",
          "a mug of eleven hulls stands, lies and rocks on the table: how fast it still moves",
          {{"speed at rest, mm/s", Combine::kMean, 0.1, 2, "what moves 2 mm/s falls asleep all the same"},
           {"way in half a second, mm", Combine::kMean, 0.1, 0.2, "not seen"}},
          RunMug};
}

}  // namespace dgd_apps
