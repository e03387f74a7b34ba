// A game that plays a sound when a contact starts and stops it when the contact ends: of what rolls, slides or lies on
// the ground there is one contact all the time, and of what lands, one start.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Motion {
  Form form;
  Ground ground;
  double half;   // m
  double speed;  // m/s; balls roll, others slide without friction.
  int index;
};

std::vector<Motion> Motions() {
  constexpr std::array kForms = {Form::kSphere, Form::kBox, Form::kHull, Form::kCylinder, Form::kCapsule};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh, Ground::kHeightfield};
  constexpr std::array<double, 4> kSpeeds = {2, 0, 5, 0.3};
  constexpr std::array<double, 3> kHalves = {0.5, 0.1, 0.25};
  std::vector<Motion> motions;
  for (const Ground ground : kGrounds) {
    for (const Form form : kForms) {
      for (const double speed : kSpeeds) {
        const int i = static_cast<int>(motions.size());
        motions.push_back({form, ground, kHalves[static_cast<std::size_t>(i + i / 4) % 3], speed, i + i / 4});
      }
    }
  }
  return motions;
}

btRigidBody& AddMoving(Lab& lab, const Motion& it, double height) {
  lab.AddGround(it.ground);
  const bool rolls = it.form == Form::kSphere;
  const double friction = rolls ? 1 : 0;
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  return lab.AddBody(shape, 1, At(Vec(0.23, 0.31, FootOf(shape) + height), Yaw(0.7 * it.index)),
                     Surface{.friction = friction});
}

/// Starts and ends per second, and the share of steps without a point, of a body in steady motion.
Case RunSteady(const Conditions& conditions, const Motion& it) {
  constexpr double kSettleTime = 0.5, kDuration = 1.5;  // s
  ContactEvents events;
  Lab lab(conditions);
  btRigidBody& body = AddMoving(lab, it, 0);
  lab.Run(kSettleTime);
  const double heading = HeadingOf(it.index);
  body.setLinearVelocity(Direction(heading) * btScalar(it.speed));
  if (it.form == Form::kSphere) body.setAngularVelocity(Direction(heading + kPi / 2) * btScalar(it.speed / it.half));
  events.Reset();
  int without_point = 0;
  const int steps = lab.StepsIn(kDuration);
  for (int step = 0; step < steps; ++step) {
    lab.Step();
    int points = 0;
    ForEachPoint(lab, [&](const btPersistentManifold&, const btManifoldPoint&) { ++points; });
    if (points == 0) ++without_point;
  }
  return {NameOf(it.ground),
          NameOf(it.form) + " " + Text(it.half) + " m, " + Text(it.speed) + " m/s on " + NameOf(it.ground),
          {events.Started() / kDuration, events.Ended() / kDuration, without_point / double(steps), 0}};
}

/// Starts beyond the first of a body that is dropped and does not rebound.
Case RunLanding(const Conditions& conditions, const Motion& it) {
  constexpr double kHeight = 0.3, kDuration = 1;  // m, s
  ContactEvents events;
  Lab lab(conditions);
  AddMoving(lab, it, kHeight * (1 + 0.3 * PhaseOf(it.index)));
  lab.Run(kDuration);
  return {NameOf(it.ground),
          NameOf(it.form) + " " + Text(it.half) + " m lands on " + NameOf(it.ground),
          {0, 0, 0, double(std::max(0, events.Started() - 1))}};
}

Cases RunEvents(const Conditions& conditions) {
  Cases cases = RunCases(conditions, Motions(), 3, RunSteady);
  AddTo(cases, RunCases(conditions, Motions(), 7, RunLanding));
  return cases;
}

}  // namespace

App Events() {
  constexpr std::string_view kFew = "a sound too many in some minutes of all cases is not heard";
  return {"events",
          "what rolls, slides, lies or lands on four kinds of ground: contacts reported as started and ended",
          {{"starts in steady motion, 1/s", Combine::kMean, 0.1, 0.05, kFew},
           {"ends in steady motion, 1/s", Combine::kMean, 0.1, 0.05, kFew},
           {"steps without a point, share", Combine::kMean, 0.1, 0.001, "the same"},
           {"starts beyond the first on landing", Combine::kMean, 0.1, 0.1, "a tenth of a knock per case"}},
          RunEvents};
}

}  // namespace dgd_apps
