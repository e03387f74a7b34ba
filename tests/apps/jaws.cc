// Two parallel jaws, plain rigid bodies on a rail that a force presses together, as assembly cells and toy claws have
// them, hold a part with two to four times the grip that it needs.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Held {
  Form part;
  double half;  // m
  int up;       // Axis of the part that is up: 0 lies across the jaws' way, 1 along it, 2 as parts stand.
  double grip;  // Over what just holds it.
  int index;
};

std::vector<Held> HeldParts() {
  std::vector<Held> parts;
  for (const Form part : {Form::kCylinder, Form::kHull, Form::kSphere, Form::kBox}) {
    for (const double half : {0.01, 0.03, 0.06}) {
      for (const int up : {2, 0, 1}) {
        const int i = static_cast<int>(parts.size());
        parts.push_back({part, half, up, i % 2 == 0 ? 2.0 : 4.0, i});
      }
    }
  }
  return parts;
}

/// What a dropped part counts, so that to drop it is no way to a better figure, mm.
constexpr double kSlipOfDropped = 10;

Case RunHeld(const Conditions& conditions, const Held& it) {
  constexpr double kSettleTime = 0.3, kHoldTime = 2;                        // s
  constexpr double kFriction = 0.6, kDensity = 2000, kJawThickness = 0.01;  // kg/m^3, m
  Lab lab(conditions);
  btConvexShape& shape = lab.MakeForm(it.part, it.half);
  const double mass = kDensity * 6 * it.half * it.half * it.half;
  const btQuaternion turn =
      it.up == 2 ? Yaw(0) : btQuaternion(it.up == 0 ? Vec(1, 0, 0) : Vec(0, 1, 0), btScalar(kPi / 2));
  const btVector3 along = quatRotate(turn.inverse(), Vec(1, 0, 0));
  const double reach = double(shape.localGetSupportingVertex(along).dot(along));
  btRigidBody& part = lab.AddBody(shape, mass, At(Vec(0, 0, 0), turn), Surface{.friction = kFriction});
  auto& jaw_shape = lab.Make<btBoxShape>(Vec(kJawThickness, it.half, it.half));
  std::vector<btRigidBody*> jaws;
  for (const int side : {-1, 1}) {
    const btVector3 place = Vec(side * (reach + kJawThickness + 1e-4), 0, 0);
    btRigidBody& jaw = lab.AddBody(jaw_shape, 0.5, At(place), Surface{.friction = 1});
    jaw.setLinearFactor(Vec(1, 0, 0));
    jaw.setAngularFactor(Vec(0, 0, 0));
    jaws.push_back(&jaw);
  }
  const double force = it.grip * mass * kGravity / (2 * kFriction);
  const auto run = [&](double seconds) {
    for (int step = lab.StepsIn(seconds); step > 0; --step) {
      for (btRigidBody* jaw : jaws) {
        const double side = jaw == jaws.front() ? 1 : -1;
        jaw->applyCentralForce(Vec(side * force, 0, 0));
      }
      lab.Step();
    }
  };
  run(kSettleTime);
  const double before = HeightOf(part);
  run(kHoldTime);
  const bool is_held = HeightOf(part) > -it.half;
  const double slip = std::abs(HeightOf(part) - before);
  constexpr std::array kUps = {"lying", "across", "upright"};
  return {NameOf(it.part),
          NameOf(it.part) + " of " + Text(100 * it.half) + " cm, " + kUps[static_cast<std::size_t>(it.up)] +
              ", grip times " + Text(it.grip),
          {is_held ? 0.0 : 1.0, is_held ? 1000 * slip : kSlipOfDropped}};
}

Cases RunJaws(const Conditions& conditions) { return RunCases(conditions, HeldParts(), 1, RunHeld); }

}  // namespace

App Jaws() {
  return {"jaws",
          "two parallel jaws on a rail hold parts of 1 to 6 cm",
          {{"dropped parts", Combine::kTotal, 0, 1, "one of nine that the solver just holds is chance"},
           {"slip in 2 s, mm", Combine::kMean, 0.1, 1.2, "one more of nine is dropped, which counts 10 mm"}},
          RunJaws};
}

}  // namespace dgd_apps
