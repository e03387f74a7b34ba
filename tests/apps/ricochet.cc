// Shots that glance off, and shots that just miss: apps such as Godot 3 and Gazebo take a point with getDistance() < 0
// for a hit, others a started contact or an impulse.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Shot {
  Form form, target;
  bool is_free;   // Whether the target is.
  double speed;   // m/s
  double offset;  // Of the line of flight from the target's centre, m: hits, grazes or misses.
  int index;
};

constexpr double kShotHalf = 0.2, kTargetHalf = 0.5;  // m

std::vector<Shot> Shots() {
  constexpr std::array kForms = {Form::kBox, Form::kSphere, Form::kHull, Form::kCapsule, Form::kCylinder};
  constexpr std::array kTargets = {Form::kBox, Form::kHull, Form::kSphere};
  constexpr std::array<double, 4> kSpeeds = {10, 3, 30, 1};
  std::vector<Shot> shots;
  for (int i = 0; i < 120; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    shots.push_back(
        {kForms[j % 5], kTargets[(j / 5) % 3], i % 4 == 3, kSpeeds[(j + j / 4) % 4], 0.15 + 0.65 * PhaseOf(i), i});
  }
  return shots;
}

std::string NameOf(const Shot& it) {
  return dgd_physics::NameOf(it.form) + " at " + dgd_physics::NameOf(it.target) + (it.is_free ? " (free)" : "") + ", " +
         Text(it.speed) + " m/s, off by " + Text(it.offset) + " m";
}

Case RunShot(const Conditions& conditions, const Shot& it) {
  ContactEvents events;
  Lab lab(conditions, 0);
  btConvexShape& target_shape = lab.MakeForm(it.target, kTargetHalf);
  const btTransform target_pose = At(Vec(0, 0, 0), Yaw(1.2 + 0.3 * (it.index % 7)));
  const Surface surface = {.friction = 0.3};
  btRigidBody& target = it.is_free ? lab.AddBody(target_shape, 1, target_pose, surface)
                                   : lab.AddStatic(target_shape, target_pose, surface);
  const double distance = 1.2 + it.speed * lab.dt() * PhaseOf(3 * it.index + 1);
  btRigidBody& body = lab.AddBody(lab.MakeForm(it.form, kShotHalf), 1,
                                  At(Vec(-distance, it.offset, 0.1), Yaw(0.4 * it.index)), surface);
  const btVector3 velocity = Vec(it.speed, 0, 0);
  body.setLinearVelocity(velocity);
  bool has_overlap = false, has_impulse = false;
  for (int step = lab.StepsIn(4 / it.speed); step > 0; --step) {
    lab.Step();
    ForEachPoint(lab, [&](const btPersistentManifold&, const btManifoldPoint& point) {
      if (point.getDistance() < 0) has_overlap = true;
      if (point.getAppliedImpulse() > 0) has_impulse = true;
    });
  }
  const double change = double((body.getLinearVelocity() - velocity).length()) / it.speed;
  const bool is_hit = change > 0.01 || double(target.getLinearVelocity().length()) > 0.01 * it.speed;
  const auto share = [](bool is_so) { return is_so ? 1.0 : 0.0; };
  return {"at " + dgd_physics::NameOf(it.target),
          NameOf(it) + (is_hit ? ": hit" : ": miss"),
          {share(is_hit && !has_overlap), share(is_hit && !has_impulse), share(is_hit && events.Started() == 0),
           share(is_hit && events.Started() != events.Ended()), share(!is_hit && has_overlap)}};
}

Cases RunRicochet(const Conditions& conditions) { return RunCases(conditions, Shots(), 3, RunShot); }

}  // namespace

App Ricochet() {
  constexpr std::string_view kSingle = "a graze or two in which a bit of roundoff decides";
  return {"ricochet",
          "bodies that glance off others or just miss: hits that an app does not see, and hits that are none",
          {{"hits without distance < 0", Combine::kTotal, 0, 1, kSingle},
           {"hits without an impulse", Combine::kTotal, 0, 0, "an impulse is what makes a hit"},
           {"hits without a started contact", Combine::kTotal, 0, 0, "the same"},
           {"hits started but not ended", Combine::kTotal, 0, 1, "what turns slowly may still touch at the end"},
           {"misses with distance < 0", Combine::kTotal, 0, 1, kSingle}},
          RunRicochet};
}

}  // namespace dgd_apps
