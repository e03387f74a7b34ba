// What lies still falls asleep and costs nothing; it wakes up when it is hit or its support goes, and not otherwise.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

constexpr double kPiledHalf = 0.25;  // m

struct Pile {
  Form form;
  Ground ground;
  int count;
  int index;
};

std::vector<btRigidBody*> AddPile(Lab& lab, const Pile& it) {
  std::vector<btRigidBody*> bodies;
  btConvexShape& shape = lab.MakeForm(it.form, kPiledHalf);
  const double foot = FootOf(shape);
  for (int i = 0; i < it.count; ++i) {
    const btTransform pose = At(Vec(0.23 + 0.01 * i, 0.31, foot * (1 + 2.02 * i) + 0.01), Yaw(HeadingOf(it.index + i)));
    bodies.push_back(&lab.AddBody(shape, 1, pose, Surface{.friction = 0.7}));
    bodies.back()->forceActivationState(ACTIVE_TAG);
  }
  return bodies;
}

bool AreAsleep(const std::vector<btRigidBody*>& bodies) {
  return std::ranges::all_of(bodies, [](const btRigidBody* it) { return it->getActivationState() == ISLAND_SLEEPING; });
}

/// @return the time it takes.
double RunUntilAsleep(Lab& lab, const std::vector<btRigidBody*>& bodies) {
  constexpr double kLongest = 6;  // s
  double seconds = 0;
  for (; seconds < kLongest && !AreAsleep(bodies); seconds += lab.dt()) lab.Step();
  return seconds;
}

/// Seconds until a pile sleeps, the steps in which it is awake after that, and whether it wakes for what concerns it.
Case RunPile(const Conditions& conditions, const Pile& it) {
  constexpr double kUndisturbed = 1, kNoticed = 0.3;  // s
  Lab lab(conditions);
  btRigidBody& ground = lab.AddGround(it.ground);
  ground.forceActivationState(ISLAND_SLEEPING);  // As Bullet has static bodies.
  const std::vector<btRigidBody*> bodies = AddPile(lab, it);
  const double seconds = RunUntilAsleep(lab, bodies);
  int awake = 0;
  for (int step = lab.StepsIn(kUndisturbed); step > 0; --step) {
    lab.Step();
    if (!AreAsleep(bodies)) ++awake;
  }
  // A ball hits the uppermost one, and is taken away.
  constexpr double kBall = 0.1, kDrop = 0.1;  // m
  const btVector3 top = PositionOf(*bodies.back());
  btRigidBody& ball =
      lab.AddBody(lab.Make<btSphereShape>(btScalar(kBall)), 1, At(top + Vec(0, 0, kPiledHalf + kBall + kDrop)));
  lab.Run(std::sqrt(2 * (kDrop + kPiledHalf) / kGravity) + kNoticed);
  const bool sleeps_through_hit = AreAsleep(bodies);
  ball.setWorldTransform(At(Vec(0, 0, 50)));
  ball.setLinearVelocity(Vec(0, 0, 0));
  ball.setGravity(Vec(0, 0, 0));
  RunUntilAsleep(lab, bodies);
  // The ground goes down, as lifts do.
  ground.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  ground.forceActivationState(DISABLE_DEACTIVATION);
  const double before = HeightOf(*bodies.front());
  for (int step = lab.StepsIn(kNoticed); step > 0; --step) {
    ground.setWorldTransform(At(Vec(0, 0, -lab.dt())) * ground.getWorldTransform());
    lab.Step();
  }
  const bool floats = HeightOf(*bodies.front()) > before - 0.5 * kNoticed;
  return {NameOf(it.form),
          Text(it.count) + " " + NameOf(it.form) + " on " + NameOf(it.ground),
          {seconds, awake * lab.dt(), sleeps_through_hit ? 1.0 : 0.0, floats ? 1.0 : 0.0}};
}

std::vector<Pile> Piles() {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder, Form::kSphere};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kMesh, Ground::kPlane, Ground::kHeightfield};
  std::vector<Pile> piles;
  for (int i = 0; i < 16; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const Form form = kForms[j % 4];
    piles.push_back({form, kGrounds[(j + j / 4) % 4], form == Form::kSphere ? 1 : 1 + i % 3, i});
  }
  return piles;
}

Cases RunSleeping(const Conditions& conditions) { return RunCases(conditions, Piles(), 3, RunPile); }

}  // namespace

App Sleeping() {
  return {"sleeping",
          "bodies and stacks that come to rest, are hit, and lose their ground: when they sleep and wake",
          {{"seconds until asleep", Combine::kMean, 0.1, 0.1, "Bullet waits for 2 s in any case"},
           {"seconds awake undisturbed", Combine::kTotal, 0, 0.1, "a tenth of a second of all"},
           {"sleeps through a hit", Combine::kTotal, 0, 0, "one is one too many"},
           {"floats when the ground goes", Combine::kTotal, 0, 0, "the same"}},
          RunSleeping};
}

}  // namespace dgd_apps
