// What slides over a floor made of pieces must not stumble over their seams: flush boxes, fine meshes, heightfields.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Floor { kFineMesh, kTiles, kFineHeightfield };

std::string NameOf(Floor floor) {
  if (floor == Floor::kTiles) return "flush boxes";
  return floor == Floor::kFineMesh ? "10 cm mesh" : "10 cm heightfield";
}

constexpr double kWay = 2.5;  // m

void AddFloor(Lab& lab, Floor floor, double margin, double heading) {
  const btTransform frame = At(Direction(heading) * btScalar(0.5 * kWay), Yaw(floor == Floor::kTiles ? heading : 0));
  const Surface smooth = {.friction = 0};
  if (floor != Floor::kTiles) {
    const Grid grid = {.cells = 36, .pitch = 0.1, .alternates = true};
    lab.AddGround(floor == Floor::kFineMesh ? Ground::kMesh : Ground::kHeightfield, frame, grid, smooth);
    return;
  }
  btBoxShape& tile = MakeCube(lab, 0.5);
  tile.setMargin(btScalar(margin));
  for (int i = -3; i < 4; ++i) {
    for (int j = -1; j < 2; ++j) lab.AddStatic(tile, frame * At(Vec(i, j, -0.5)), smooth);
  }
}

struct Slide {
  Floor floor;
  Form form;
  double half, margin, speed;  // m, m, m/s
  int index;
};

std::vector<Slide> Slides() {
  constexpr std::array<double, 5> kSpeeds = {1, 5, 0.3, 20, 2};
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder};
  constexpr std::array<double, 3> kHalves = {0.25, 0.1, 0.5};
  std::vector<Slide> slides;
  for (const Floor floor : {Floor::kFineMesh, Floor::kTiles, Floor::kFineHeightfield}) {
    for (const Form form : kForms) {
      for (const double speed : kSpeeds) {
        for (const double margin : {0.04, 0.001}) {
          const std::size_t i = slides.size();
          slides.push_back({floor, form, kHalves[(i / 10 + i) % 3], margin, speed, static_cast<int>(i)});
        }
      }
    }
  }
  return slides;
}

Case RunSlide(const Conditions& conditions, const Slide& it) {
  constexpr double kLongest = 2.5;  // s
  Lab lab(conditions);
  const double heading = HeadingOf(it.index);
  AddFloor(lab, it.floor, it.margin, heading);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  if (it.form != Form::kHull) shape.setMargin(btScalar(std::min(it.margin, 0.2 * it.half)));
  const double foot = FootOf(shape);
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0.013, 0.031, foot), Yaw(heading)), Surface{.friction = 0});
  lab.Run(0.3);
  body.setLinearVelocity(Direction(heading) * btScalar(it.speed));
  double hop = 0;
  const double seconds = std::min(kLongest, kWay / it.speed);
  for (int step = lab.StepsIn(seconds); step > 0; --step) {
    lab.Step();
    hop = std::max(hop, HeightOf(body) - foot);
  }
  const double way = Along(PositionOf(body), heading);
  return {NameOf(it.floor),
          NameOf(it.form) + " " + Text(it.half) + " m, margin " + Text(it.margin) + ", " + Text(it.speed) + " m/s on " +
              NameOf(it.floor),
          {std::abs(double(Along(body.getLinearVelocity(), heading)) / it.speed - 1),
           way < 0.8 * it.speed * seconds ? 1.0 : 0.0, 1000 * hop}};
}

Cases RunSliding(const Conditions& conditions) { return RunCases(conditions, Slides(), 7, RunSlide); }

}  // namespace

App Sliding() {
  return {"sliding",
          "frictionless bodies slide over flush boxes and fine meshes: speed lost at seams",
          {{"change of the speed, share", Combine::kMean, 0.1, 0.002, "a player sees percents"},
           {"stopped or late", Combine::kTotal, 0, 0, "one is one too many"},
           {"hop, mm", Combine::kWorst, 0.1, 0.5, "half a millimetre is the built-in's push-out of a resting box"}},
          RunSliding};
}

}  // namespace dgd_apps
