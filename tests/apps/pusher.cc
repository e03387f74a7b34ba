// Kinematic bodies that the app moves by their pose: a bulldozer, a post, a lift and a turntable.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

constexpr double kLoadHalf = 0.3;  // Of the loads, m.

/// What pushes three loads over the floor.
struct Push {
  Form pusher, load;
  double speed;   // m/s
  bool has_wall;  // Which stops the loads; the pusher stops when they just fit between.
  int index;
};

/// Deepest overlap with the pusher, and how far loads got away ahead of it.
Case RunPush(const Conditions& conditions, const Push& it) {
  Lab lab(conditions);
  lab.AddGround(Ground::kBox);
  const double heading = HeadingOf(it.index);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(heading));
  btConvexShape& shape = it.pusher == Form::kCapsule
                             ? static_cast<btConvexShape&>(lab.Make<btCapsuleShapeZ>(btScalar(0.4), btScalar(1)))
                             : lab.Make<btBoxShape>(Vec(0.4, 1, 0.5));
  const double height = FootOf(shape) + 0.01;
  double x = -2 - PhaseOf(it.index) * it.speed * lab.dt();
  btRigidBody& pusher = lab.AddKinematic(shape, frame * At(Vec(x, 0, height)));
  btConvexShape& load = lab.MakeForm(it.load, kLoadHalf);
  std::vector<btRigidBody*> loads;
  for (int i = -1; i < 2; ++i) {
    loads.push_back(&lab.AddBody(load, 1, frame * At(Vec(-1, 0.62 * i, FootOf(load))), Surface{.friction = 0.4}));
    loads.back()->setRollingFriction(btScalar(0.02));
  }
  const double wall = 1;
  if (it.has_wall) lab.AddStatic(MakeCube(lab, 2), frame * At(Vec(wall + 2, 0, 2)));
  double overlap = 0, ahead = 0;
  for (int step = lab.StepsIn(2.5 / it.speed); step > 0; --step) {
    if (!it.has_wall || x < wall - 0.4 - 2 * kLoadHalf - it.speed * lab.dt()) x += it.speed * lab.dt();
    pusher.setWorldTransform(frame * At(Vec(x, 0, height)));
    lab.Step();
    overlap = std::max(overlap, DeepestOverlap(lab, &pusher));
    // Once they have been reached.
    if (x < -1) continue;
    for (const btRigidBody* body : loads)
      ahead = std::max(ahead, Along(PositionOf(*body), heading) - x - 0.4 - kLoadHalf);
  }
  // Only where loads stay in front and nothing stops them: a post lets the outer ones go by.
  const bool counts_ahead = it.pusher != Form::kCapsule && it.load == Form::kBox && !it.has_wall;
  return {"pushes",
          NameOf(it.pusher) + " pushes " + NameOf(it.load) + " at " + Text(it.speed) + " m/s" +
              (it.has_wall ? " to a wall" : ""),
          {1000 * overlap, counts_ahead ? 1000 * ahead : 0, 0}};
}

/// A stack on a platform that the app moves: overlap, and how far the lowest body of the stack strays on it.
Case RunLift(const Conditions& conditions, Form form, bool turns, double speed, int index) {
  constexpr double kDuration = 1.5;  // s
  Lab lab(conditions);
  btRigidBody& platform = lab.AddKinematic(lab.Make<btBoxShape>(Vec(2, 2, 0.5)), At(Vec(0, 0, -0.5)));
  btConvexShape& shape = lab.MakeForm(form, kLoadHalf);
  std::vector<const btRigidBody*> bodies;
  for (int i = 0; i < 3; ++i) {
    const btTransform pose = At(Vec(0.1, 0.05, FootOf(shape) * (1 + 2 * i)), Yaw(HeadingOf(index)));
    bodies.push_back(&lab.AddBody(shape, 1, pose, Surface{.friction = 0.8}));
  }
  lab.Run(0.3);
  std::vector<btVector3> starts;
  for (const btRigidBody* body : bodies) starts.push_back(PositionOf(*body));
  double overlap = 0, time = 0;
  btTransform motion = btTransform::getIdentity();
  for (int step = lab.StepsIn(kDuration); step > 0; --step) {
    time += lab.dt();
    // Half a period up and half down, without a jump of the velocity.
    const double part = 0.5 * (1 - std::cos(2 * kPi * time / kDuration));
    motion = turns ? At(Vec(0, 0, 0), Yaw(speed * part)) : At(Vec(0, 0, speed * part * kDuration / kPi));
    platform.setWorldTransform(motion * At(Vec(0, 0, -0.5)));
    lab.Step();
    overlap = std::max(overlap, DeepestOverlap(lab, &platform));
  }
  double strays = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    strays = std::max(strays, double((PositionOf(*bodies[i]) - motion * starts[i]).length()));
  return {turns ? "turntable" : "lift",
          std::string(turns ? "turntable" : "lift") + " with three of " + NameOf(form) + ", " + Text(speed) +
              (turns ? " rad" : " m/s"),
          {1000 * overlap, 0, 1000 * strays}};
}

Cases RunPusher(const Conditions& conditions) {
  constexpr std::array<double, 3> kSpeeds = {1, 0.2, 5};
  constexpr std::array kLoads = {Form::kBox, Form::kHull, Form::kCylinder};
  Cases cases;
  for (const int i : SelectIndices(conditions, 27, 5)) {
    const std::size_t j = static_cast<std::size_t>(i);
    const Form pusher = i % 4 == 3 ? Form::kCapsule : Form::kBox;
    cases.push_back(RunPush(conditions, {pusher, kLoads[(j / 3) % 3], kSpeeds[j % 3], i % 7 >= 5, i}));
  }
  for (const int i : SelectIndices(conditions, 12, 3)) {
    const bool turns = i % 2 == 1;
    const double speed = (turns ? 0.5 : 1) * (1 + (i / 2) % 2);
    cases.push_back(RunLift(conditions, kLoads[static_cast<std::size_t>(i / 3) % 3], turns, speed, i));
  }
  return cases;
}

}  // namespace

App Pusher() {
  return {"pusher",
          "kinematic bodies push loads over the floor and to a wall, and carry stacks up and around",
          {{"deepest overlap with the pusher, mm", Combine::kMean, 0.1, 0.5, "half a millimetre is not seen"},
           {"loads get away ahead, mm", Combine::kMean, 0.1, 1, "a millimetre is not seen"},
           {"stray on the lift, mm", Combine::kMean, 0.1, 0.5, "half a millimetre is not seen"}},
          RunPusher};
}

}  // namespace dgd_apps
