// A ball that hits a wall with a slip: Newton's restitution along the normal, Coulomb's friction in the impact. The
// contact either sticks, which takes 2/7 of the slip off the ball's velocity, or slides, which takes off mu (1 + e)
// times the speed of approach: Garwin, Kinematics of an ultraelastic rough ball, 1969, without its tangential
// restitution. Two free bodies that hit each other keep their angular momentum in any impact.
#include "physics/spin_rebound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/lab.h"

namespace dgd_physics {
namespace {

struct Rebound {
  Ground ground;
  double radius, speed;  // m, m/s
  double elevation;      // Of the way in over the wall, rad.
  double friction, restitution;
  double spin;  // Of the surface, over the speed.
  int index;
};

std::vector<Rebound> ReboundCases() {
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh};
  constexpr std::array<double, 5> kSpeeds = {3, 12, 1.5, 6, 25};  // m/s
  constexpr std::array<double, 3> kRadii = {0.15, 0.5, 0.05};     // m
  constexpr std::array<double, 4> kElevations = {0.5, 1.4, 0.9, 0.25};
  constexpr std::array<double, 3> kFrictions = {0.2, 0.6, 0.1};
  constexpr std::array<double, 3> kRestitutions = {0.8, 0.5, 1};
  constexpr std::array<double, 4> kSpins = {0, 0.8, -1.5, 0.4};
  std::vector<Rebound> cases;
  for (int i = 0; i < 48; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kGrounds[j % 3], kRadii[(j + j / 3) % 3], kSpeeds[j % 5], kElevations[j % 4],
                     kFrictions[(j + j / 6) % 3], kRestitutions[(j + j / 9) % 3], kSpins[(j + j / 4) % 4], i});
  }
  return cases;
}

/// Velocity and spin after the impact, over the speed. The wall is tilted, and there is no gravity.
Samples MeasureRebound(const Conditions& conditions, const Rebound& it) {
  Lab lab(conditions, 0);
  const btTransform wall = At(Vec(0, 0, 0), btQuaternion(Vec(0.6, 0.8, 0), btScalar(0.5 * (it.index % 3))));
  lab.AddGround(it.ground, wall, {}, Surface{.friction = 1, .restitution = 1});
  const double along = it.speed * std::cos(it.elevation), down = it.speed * std::sin(it.elevation);
  const double gap = 0.05 + down * lab.dt() * (3 + PhaseOf(it.index));
  const btVector3 direction = Direction(HeadingOf(it.index) + it.index), normal = Vec(0, 0, 1);
  const btVector3 velocity = direction * btScalar(along) - normal * btScalar(down);
  // Neither along its way nor across it.
  const btVector3 spin = Direction(2.1 * it.index) * btScalar(it.spin * it.speed / it.radius) + normal;
  const btVector3 arm = normal * btScalar(-it.radius);
  const btVector3 slip = direction * btScalar(along) + spin.cross(arm);
  const double slip_speed = double(slip.length());
  const double most = it.friction * (1 + it.restitution) * down;
  const btVector3 impulse = slip * btScalar(-std::min(2.0 / 7, slip_speed > 0 ? most / slip_speed : 0));
  const btVector3 theory = direction * btScalar(along) + impulse + normal * btScalar(it.restitution * down);
  const btVector3 spin_theory = spin + arm.cross(impulse) * btScalar(2.5 / (it.radius * it.radius));

  const btVector3 start = direction * btScalar(-along * gap / down) + Vec(0, 0, it.radius + gap);
  btRigidBody& ball = lab.AddBody(lab.Make<btSphereShape>(btScalar(it.radius)), 1, wall * At(start),
                                  Surface{.friction = it.friction, .restitution = it.restitution});
  const btMatrix3x3& basis = wall.getBasis();
  ball.setLinearVelocity(basis * velocity);
  ball.setAngularVelocity(basis * spin);
  lab.Run(gap / down + 5 * lab.dt());
  const double off = double((ball.getLinearVelocity() * basis - theory).length());
  const double spin_off = it.radius * double((ball.getAngularVelocity() * basis - spin_theory).length());
  const std::string name = "ball " + Text(it.radius) + " m on " + NameOf(it.ground) + ", " + Text(it.speed) + " m/s, " +
                           Text(it.elevation) + " rad, mu " + Text(it.friction) + ", e " + Text(it.restitution) +
                           ", spin " + Text(it.spin);
  return {Sample{name + ": velocity off", off / it.speed, 0, 1, NameOf(it.ground)},
          Sample{name + ": spin off", spin_off / it.speed, 0, 1, NameOf(it.ground)}};
}

struct Meeting {
  Form first, second;
  double half;  // m
  double pace;  // Way within a step, over the half size.
  double mass_ratio, friction, restitution;
  double aside;  // Of their centres across their way, over the half size.
  int index;
};

std::vector<Meeting> MeetingCases() {
  constexpr std::array<std::array<Form, 2>, 4> kPairs = {{{Form::kSphere, Form::kSphere},
                                                          {Form::kBox, Form::kBox},
                                                          {Form::kHull, Form::kCylinder},
                                                          {Form::kSphere, Form::kBox}}};
  constexpr std::array<double, 5> kPaces = {0.1, 0.02, 0.3, 0.05, 0.2};
  constexpr std::array<double, 3> kHalves = {0.25, 0.5, 0.1};  // m
  constexpr std::array<double, 3> kMassRatios = {1, 3, 0.3};
  constexpr std::array<double, 3> kFrictions = {0.5, 0.2, 0.9};
  constexpr std::array<double, 3> kRestitutions = {0.8, 0.5, 1};
  constexpr std::array<double, 4> kAsides = {0.3, 0.6, 0, 0.45};
  std::vector<Meeting> cases;
  for (int i = 0; i < 40; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kPairs[j % 4][0], kPairs[j % 4][1], kHalves[(j + j / 4) % 3], kPaces[j % 5], kMassRatios[j % 3],
                     kFrictions[(j + j / 3) % 3], kRestitutions[(j + j / 6) % 3], kAsides[(j + j / 4) % 4], i});
  }
  return cases;
}

/// About the origin, kg m^2/s.
btVector3 AngularMomentumOf(const btRigidBody& body) {
  const btMatrix3x3& basis = body.getWorldTransform().getBasis();
  const btVector3 spin = body.getAngularVelocity() * basis;
  const btVector3& inverse = body.getInvInertiaDiagLocal();
  const btVector3 own(spin.x() / inverse.x(), spin.y() / inverse.y(), spin.z() / inverse.z());
  return PositionOf(body).cross(body.getLinearVelocity()) / body.getInvMass() + basis * own;
}

/// Change of the angular momentum in an impact, over that of the reduced mass at half the size and the relative speed.
/// 1 if they pass through each other.
Sample MeasureMeeting(const Conditions& conditions, const Meeting& it) {
  Lab lab(conditions, 0);
  const double speed = it.pace * it.half / lab.dt();
  const btTransform frame = At(Vec(0, 0, 0), btQuaternion(Vec(0.48, 0.64, 0.6), btScalar(0.7 * (it.index % 5))));
  btConvexShape& first_shape = lab.MakeForm(it.first, it.half);
  btConvexShape& second_shape = lab.MakeForm(it.second, it.half);
  const double gap = 0.05 + speed * lab.dt() * (2 + PhaseOf(it.index));
  const double apart = ExtentOf(first_shape, Vec(0, 0, 1)) + ExtentOf(second_shape, Vec(0, 0, -1)) + gap;
  const Surface surface = {.friction = std::sqrt(it.friction), .restitution = std::sqrt(it.restitution)};
  btRigidBody& first = lab.AddBody(first_shape, 1, frame, surface);
  btRigidBody& second =
      lab.AddBody(second_shape, it.mass_ratio, frame * At(Vec(it.aside * it.half, 0, apart), Yaw(0.5)), surface);
  // A slip along the other axis than the one they miss each other by.
  const btMatrix3x3& basis = frame.getBasis();
  first.setLinearVelocity(basis * Vec(0, 0.2 * speed, 0.6 * speed));
  second.setLinearVelocity(basis * Vec(0, 0, -0.4 * speed));
  if (it.first == Form::kSphere) first.setAngularVelocity(basis * Vec(0.3 * speed / it.half, 0, 0));
  const btVector3 before = AngularMomentumOf(first) + AngularMomentumOf(second);
  // Spheres that miss the middle meet later.
  lab.Run((gap + 0.2 * it.half) / speed + 3 * lab.dt());
  const btVector3 change = AngularMomentumOf(first) + AngularMomentumOf(second) - before;
  const bool have_met = double((second.getLinearVelocity() * basis).z()) > -0.399 * speed;
  const double scale = it.mass_ratio / (1 + it.mass_ratio) * it.half * speed;
  return {NameOf(it.first) + " and " + NameOf(it.second) + " " + Text(it.half) + " m, " + Text(it.pace) +
              " of it a step, mass " + Text(it.mass_ratio) + ", mu " + Text(it.friction) + ", e " +
              Text(it.restitution) + ", aside " + Text(it.aside) + ": angular momentum",
          have_met ? double(change.length()) / scale : 1, 0, 1, it.first == it.second ? NameOf(it.first) : "others"};
}

}  // namespace

Samples MeasureSpinRebound(const Conditions& conditions) {
  Samples samples;
  for (const Rebound& it : SelectCases(conditions, ReboundCases(), 5)) AddTo(samples, MeasureRebound(conditions, it));
  return samples;
}

Samples MeasureAngularMomentum(const Conditions& conditions) {
  return MeasureCases(conditions, MeetingCases(), 5,
                      [](const Conditions& under, const Meeting& it) { return MeasureMeeting(under, it); });
}

}  // namespace dgd_physics
