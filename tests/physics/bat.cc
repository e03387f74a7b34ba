#include <cmath>
#include <vector>

#include "physics/lab.h"
#include "physics/restitution.h"

namespace dgd_physics {
namespace {

struct Bat {
  Form form;     // Of the body that it hits, which is at rest.
  double half;   // m
  double speed;  // Of the bat where it hits, across its face, m/s.
  double arm;    // From the axis that the bat turns about, m; 0 if it moves straight.
  double slant;  // Between the way of a straight bat and its normal, radians.
  double restitution;
  int index;

  std::string Name() const {
    return NameOf(form) + " " + Text(half) + " m, bat at " + Text(speed) + " m/s" +
           (arm > 0 ? " turns, " + Text(arm) + " m from the axis" : ", slant " + Text(slant)) + ", e " +
           Text(restitution);
  }
};

std::vector<Bat> BatCases() {
  constexpr std::array kForms = {Form::kSphere, Form::kBox, Form::kHull};
  constexpr std::array<double, 5> kSpeeds = {1, 4, 0.5, 8, 2};      // m/s
  constexpr std::array<double, 4> kTurningSpeeds = {1, 3, 0.6, 2};  // m/s
  constexpr std::array<double, 3> kHalves = {0.1, 0.2, 0.05};       // m
  constexpr std::array<double, 3> kArms = {0.5, 0.8, 0.6};          // m
  constexpr std::array<double, 3> kSlants = {0, 0.5, 0.2};          // rad
  constexpr std::array<double, 3> kRestitutions = {1, 0.8, 0.5};
  std::vector<Bat> cases;
  for (int i = 0; i < 48; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    Bat bat = {kForms[j / 2 % 3],
               kHalves[(j + j / 6) % 3],
               kSpeeds[j % 5],
               0,
               kSlants[(j / 2 + j / 6) % 3],
               kRestitutions[(j + j / 3) % 3],
               i};
    if (i % 2 == 1) {
      bat.form = Form::kSphere;  // A face would not be met squarely.
      bat.speed = kTurningSpeeds[j / 2 % 4];
      bat.arm = kArms[j / 2 % 3];
      bat.slant = 0;
    }
    cases.push_back(bat);
  }
  return cases;
}

/// The body that has been hit would be caught up with if the bat turned by a radian more.
constexpr double kMostTurnAfterHit = 0.4;  // rad

/// What the callback of a turning bat refers to.
struct Turning {
  btRigidBody* bat = nullptr;
  btVector3 spin = Vec(0, 0, 0);
};

/// From the poses before and after a step of a millisecond, Bullet in float computes a spin that is off by a tenth.
void SetSpin(btDynamicsWorld* world, btScalar) {
  const Turning& turning = *static_cast<const Turning*>(world->getWorldUserInfo());
  turning.bat->setAngularVelocity(turning.spin);
}

/// A bat that the app moves, with a face of 2 m by 2 m, hits a body at rest without friction: speed at which it leaves,
/// along the face's normal. The face looks along z where it hits.
Sample MeasureBat(const Conditions& conditions, const Bat& it) {
  constexpr double kHalfThickness = 0.05;  // m
  Lab lab(conditions, 0);
  const btTransform frame = At(Vec(0, 0, 0), btQuaternion(Vec(0.6, 0.64, 0.48), btScalar(0.7 * (it.index % 5))));
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const btVector3 place = Vec(it.arm, 0.1, kHalfThickness + FootOf(shape));
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(place), Surface{.friction = 0, .restitution = it.restitution});
  const double hit = 0.05 + lab.dt() * (3 + PhaseOf(it.index));  // s
  const btVector3 way = Vec(it.speed * std::tan(it.slant), 0, it.speed);
  const double spin = it.arm > 0 ? it.speed / it.arm : 0;
  const btVector3 axis = Vec(0, -1, 0);  // It carries the face to +z at +x.
  const auto pose_at = [&](double time) {
    if (it.arm == 0) return frame * At(way * btScalar(time - hit));
    return frame * At(Vec(0, 0, 0), btQuaternion(axis, btScalar(spin * (time - hit))));
  };
  btRigidBody& bat =
      lab.AddKinematic(lab.Make<btBoxShape>(Vec(1, 1, kHalfThickness)), pose_at(0), {.friction = 0, .restitution = 1});
  Turning turning = {&bat, frame.getBasis() * axis * btScalar(spin)};
  if (it.arm > 0) lab.world().setInternalTickCallback(SetSpin, &turning, true);
  lab.RunMoving(bat, hit + (it.arm > 0 ? kMostTurnAfterHit / spin : 0.1), pose_at);
  const double leaving = double((body.getLinearVelocity() * frame.getBasis()).z());
  return RelativeToTheory(it.Name(), leaving / it.speed, 1 + it.restitution, it.arm > 0 ? "turning" : "straight");
}

}  // namespace

Samples MeasureBat(const Conditions& conditions) {
  return MeasureCases(conditions, BatCases(), 7,
                      [](const Conditions& under, const Bat& it) { return MeasureBat(under, it); });
}

}  // namespace dgd_physics
