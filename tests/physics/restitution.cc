#include "physics/restitution.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "physics/lab.h"

namespace dgd_physics {
namespace {

// Bullet lets slower impacts rest: btContactSolverInfo::m_restitutionVelocityThreshold is 0.2 m/s. All here are faster.

struct HeadOn {
  Form first, second;
  double half;   // Half width, m.
  double speed;  // Relative, m/s.
  double mass_ratio, restitution;
  int index;
};

// Speeds at which the bodies approach by less than a third of their width within the longest step.
std::vector<HeadOn> HeadOnCases() {
  constexpr std::array<std::array<Form, 2>, 7> kPairs = {{{Form::kSphere, Form::kSphere},
                                                          {Form::kBox, Form::kBox},
                                                          {Form::kHull, Form::kHull},
                                                          {Form::kCapsule, Form::kCapsule},
                                                          {Form::kCylinder, Form::kCylinder},
                                                          {Form::kSphere, Form::kBox},
                                                          {Form::kHull, Form::kCylinder}}};
  constexpr std::array<std::array<double, 2>, 5> kSizes = {
      {{0.015, 0.5}, {0.25, 4}, {0.05, 1}, {0.15, 2.5}, {0.1, 1.5}}};
  constexpr std::array<double, 4> kMassRatios = {1, 3, 0.2, 1};
  constexpr std::array<double, 3> kRestitutions = {1, 0.7, 0.4};
  std::vector<HeadOn> cases;
  for (int round = 0; round < 2; ++round) {
    for (const auto& [first, second] : kPairs) {
      for (const auto& [half, speed] : kSizes) {
        const std::size_t i = cases.size();
        cases.push_back({first, second, half, speed, kMassRatios[i % 4], kRestitutions[i % 3], static_cast<int>(i)});
      }
    }
  }
  return cases;
}

std::string GroupOf(Form first, Form second) {
  if (first != second) return "others";
  if (first == Form::kSphere || first == Form::kCapsule) return "balls, capsules";
  return first == Form::kBox ? "boxes" : "others";
}

/// Speed at which the two part, over that at which they met.
Sample MeasureHeadOn(const Conditions& conditions, const HeadOn& it) {
  Lab lab(conditions, 0);
  const double heading = HeadingOf(it.index), slope = 0.3 * (it.index % 3);
  const btVector3 axis = Vec(std::cos(heading) * std::cos(slope), std::sin(heading) * std::cos(slope), std::sin(slope));
  btConvexShape& first_shape = lab.MakeForm(it.first, it.half);
  btConvexShape& second_shape = lab.MakeForm(it.second, it.half);
  const double gap = 0.05 + it.speed * lab.dt() * (3 + PhaseOf(it.index));
  const double apart = ExtentOf(first_shape, Vec(0, 0, 1)) + ExtentOf(second_shape, Vec(0, 0, -1)) + gap;
  btRigidBody& first = lab.AddBody(first_shape, 1, At(Vec(0, 0, 0), FromZ(axis)),
                                   Surface{.friction = 0.5, .restitution = it.restitution});
  btRigidBody& second = lab.AddBody(second_shape, it.mass_ratio, At(axis * btScalar(apart), FromZ(axis)),
                                    Surface{.friction = 0.5, .restitution = 1});
  // Not at rest, either of them.
  first.setLinearVelocity(axis * btScalar(0.7 * it.speed));
  second.setLinearVelocity(axis * btScalar(-0.3 * it.speed));
  lab.Run(gap / it.speed + 0.15 + 10 * lab.dt());
  const double parting = double((second.getLinearVelocity() - first.getLinearVelocity()).dot(axis));
  return RelativeToTheory(NameOf(it.first) + " on " + NameOf(it.second) + " " + Text(it.half) + " m, " +
                              Text(it.speed) + " m/s, mass " + Text(it.mass_ratio) + ", e " + Text(it.restitution),
                          parting / it.speed, it.restitution, GroupOf(it.first, it.second));
}

struct Bounce {
  Form form;
  Ground ground;
  double height, restitution;  // m
  double half;                 // m
  int index;
};

std::vector<Bounce> BounceCases() {
  constexpr std::array kForms = {Form::kSphere, Form::kBox, Form::kHull};
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh, Ground::kHeightfield};
  constexpr std::array<double, 5> kHeights = {0.3, 1, 3, 0.6, 1.7};
  constexpr std::array<double, 3> kRestitutions = {1, 0.8, 0.5};
  constexpr std::array<double, 4> kHalves = {0.1, 0.25, 0.5, 0.15};
  std::vector<Bounce> cases;
  for (int round = 0; round < 8; ++round) {
    for (const Ground ground : kGrounds) {
      for (const Form form : kForms) {
        const std::size_t i = cases.size();
        cases.push_back({form, ground, kHeights[i % 5], kRestitutions[(i + i / 3) % 3], kHalves[(i + i / 4) % 4],
                         static_cast<int>(i)});
      }
    }
  }
  return cases;
}

/// The greatest height of the centre between the first rebound and the next fall, over that at rest.
Sample MeasureBounce(const Conditions& conditions, const Bounce& it) {
  Lab lab(conditions);
  lab.AddGround(it.ground);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double foot = FootOf(shape), heading = HeadingOf(it.index);
  const double fall_speed = std::sqrt(2 * kGravity * it.height);
  // From heights within a step's way of each other, off the middle of a square.
  const double height = it.height + PhaseOf(it.index) * fall_speed * lab.dt();
  const btTransform pose = At(Vec(0.23, 0.31, foot + height), Yaw(heading));
  btRigidBody& body = lab.AddBody(shape, 1, pose, Surface{.friction = 0.5, .restitution = it.restitution});
  const double time_down = std::sqrt(2 * height / kGravity);
  double top = 0;
  bool has_rebounded = false;
  for (int step = lab.StepsIn((1 + 1.6 * it.restitution) * time_down); step > 0; --step) {
    lab.Step();
    const bool is_rising = body.getLinearVelocity().z() > 0;
    has_rebounded = has_rebounded || is_rising;
    if (has_rebounded) top = std::max(top, HeightOf(body) - foot);
    if (has_rebounded && !is_rising) break;
  }
  return RelativeToTheory(NameOf(it.form) + " " + Text(it.half) + " m on " + NameOf(it.ground) + " from " +
                              Text(height) + " m, e " + Text(it.restitution),
                          top, it.restitution * it.restitution * height, NameOf(it.form));
}

struct Gas {
  Ground wall;
  int balls;
  double seconds;
  unsigned seed;
};

constexpr double kGasHalfWidth = 1;     // m
constexpr double kGasBallRadius = 0.1;  // m

void AddWalls(Lab& lab, Ground wall) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      btVector3 outward(0, 0, 0);
      outward[axis] = btScalar(side);
      // Ground of either type, turned to face inwards.
      const btQuaternion inward = axis == 2 && side > 0 ? btQuaternion(Vec(1, 0, 0), btScalar(kPi)) : FromZ(-outward);
      lab.AddGround(wall, At(outward * btScalar(kGasHalfWidth), inward), {}, Surface{.friction = 0, .restitution = 1});
    }
  }
}

/// Balls on a lattice, so that none overlap, with random velocities.
std::vector<btRigidBody*> AddGas(Lab& lab, const Gas& it) {
  constexpr double kLeastSpeed = 1, kMostSpeed = 2.5;  // m/s
  constexpr int kPerSide = 4;
  btConvexShape& ball = lab.Make<btSphereShape>(btScalar(kGasBallRadius));
  std::mt19937 random(it.seed);
  const auto uniform = [&random](double least, double most) {
    return least + (most - least) * double(random() - std::mt19937::min()) / double(std::mt19937::max());
  };
  std::vector<btRigidBody*> balls;
  for (int i = 0; i < it.balls; ++i) {
    const double pitch = 2 * kGasHalfWidth / kPerSide;
    const auto place = [&](int cell) { return (cell + 0.5) * pitch - kGasHalfWidth + uniform(-0.1, 0.1); };
    const btVector3 position = Vec(place(i % kPerSide), place(i / kPerSide % kPerSide), place(i / kPerSide / kPerSide));
    btRigidBody& body = lab.AddBody(ball, uniform(0.5, 2), At(position), Surface{.friction = 0, .restitution = 1});
    const double z = uniform(-1, 1), angle = uniform(0, 2 * kPi), ring = std::sqrt(1 - z * z);
    body.setLinearVelocity(Vec(ring * std::cos(angle), ring * std::sin(angle), z) *
                           btScalar(uniform(kLeastSpeed, kMostSpeed)));
    balls.push_back(&body);
  }
  return balls;
}

Sample MeasureGas(const Conditions& conditions, const Gas& it) {
  Lab lab(conditions, 0);
  AddWalls(lab, it.wall);
  const std::vector<btRigidBody*> balls = AddGas(lab, it);
  const auto energy = [&balls] {
    double sum = 0;
    for (const btRigidBody* ball : balls) sum += KineticEnergyOf(*ball);
    return sum;
  };
  const double before = energy();
  lab.Run(it.seconds);
  return RelativeToTheory(Text(it.balls) + " balls between walls of type " + NameOf(it.wall) + ", " + Text(it.seconds) +
                              " s: kinetic energy",
                          energy() / before, 1);
}

struct ObliqueBounce {
  Ground ground;
  double radius, speed;  // m, m/s
  double elevation;      // Of the way in over the wall, radians.
  double restitution;
  int index;
};

std::vector<ObliqueBounce> ObliqueBounceCases() {
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh, Ground::kHeightfield};
  constexpr std::array<double, 4> kDegrees = {20, 35, 50, 70};
  constexpr std::array<std::array<double, 2>, 3> kSizes = {{{0.05, 1.5}, {0.15, 4}, {0.5, 7}}};
  constexpr std::array<double, 3> kRestitutions = {1, 0.7, 0.5};
  std::vector<ObliqueBounce> cases;
  for (const double degrees : kDegrees) {
    for (const Ground ground : kGrounds) {
      for (const auto& [radius, speed] : kSizes) {
        const std::size_t i = cases.size();
        cases.push_back(
            {ground, radius, speed, degrees * kPi / 180, kRestitutions[(i + i / 3) % 3], static_cast<int>(i)});
      }
    }
  }
  return cases;
}

/// Speeds along the wall and away from it after the impact. The wall is tilted, and there is no gravity.
Samples MeasureObliqueBounce(const Conditions& conditions, const ObliqueBounce& it) {
  Lab lab(conditions, 0);
  const btTransform wall = At(Vec(0, 0, 0), btQuaternion(Vec(0.6, 0.8, 0), btScalar(0.5 * (it.index % 3))));
  lab.AddGround(it.ground, wall, {}, Surface{.friction = 0, .restitution = 1});
  const double along = it.speed * std::cos(it.elevation), down = it.speed * std::sin(it.elevation);
  const double gap = 0.05 + down * lab.dt() * (3 + PhaseOf(it.index));
  const btVector3 direction = Direction(HeadingOf(it.index) + it.index);
  const btVector3 start = direction * btScalar(-along * gap / down) + Vec(0, 0, it.radius + gap);
  btRigidBody& ball = lab.AddBody(lab.Make<btSphereShape>(btScalar(it.radius)), 1, wall * At(start),
                                  Surface{.friction = 0, .restitution = it.restitution});
  const btMatrix3x3& basis = wall.getBasis();
  ball.setLinearVelocity(basis * (direction * btScalar(along) + Vec(0, 0, -down)));
  lab.Run(gap / down + 0.1 + 10 * lab.dt());
  const btVector3 after = ball.getLinearVelocity() * basis;
  const std::string name = "ball " + Text(it.radius) + " m on " + NameOf(it.ground) + ", " + Text(it.speed) + " m/s, " +
                           Text(it.elevation) + " rad, e " + Text(it.restitution);
  return {RelativeToTheory(name + ": along", double(after.dot(direction)) / along, 1),
          RelativeToTheory(name + ": away", double(after.z()) / down, it.restitution)};
}

struct Cradle {
  int balls;
  double radius, speed;  // m, m/s
  double gap;            // Between neighbours, in ways of the first ball within one step.
  int index;
};

std::vector<Cradle> CradleCases() {
  std::vector<Cradle> cases;
  for (const double gap : {2.3, 1e-3, 0.0, 3.7}) {
    // Ten iterations of Bullet's solver do not end the impacts of longer rows in one step.
    const std::vector<int> rows = gap > 1 ? std::vector{3, 5, 4, 7} : std::vector{3, 4, 3, 4};
    for (const int balls : rows) {
      const int index = static_cast<int>(cases.size());
      cases.push_back({balls, index % 2 == 0 ? 0.05 : 0.12, index % 2 == 0 ? 0.8 : 1.7, gap, index});
    }
  }
  return cases;
}

/// With gaps of some steps: how far the velocities are from those of impacts one after another, all of it passed on to
/// the last. Impacts within one step are one for Bullet's solver, and Newton's law alone does not say how the balls
/// share the velocity then: momentum and energy are judged.
Samples MeasureCradle(const Conditions& conditions, const Cradle& it) {
  Lab lab(conditions, 0);
  const btVector3 axis = Direction(HeadingOf(it.index));
  const double gap = it.gap * it.speed * lab.dt(), start = 0.05 + it.speed * lab.dt() * (3 + PhaseOf(it.index));
  btConvexShape& ball = lab.Make<btSphereShape>(btScalar(it.radius));
  std::vector<btRigidBody*> row;
  for (int i = 0; i < it.balls; ++i) {
    const double way = i == 0 ? -start : (i - 1) * gap;
    const btVector3 position = axis * btScalar(2 * it.radius * i + way);
    row.push_back(&lab.AddBody(ball, 1, At(position), Surface{.friction = 0, .restitution = 1}));
  }
  row.front()->setLinearVelocity(axis * btScalar(it.speed));
  lab.Run((start + it.balls * gap) / it.speed + 0.1 + 10 * lab.dt());
  double momentum = 0, energy = 0, squares = 0;  // Relative to what comes in.
  for (const btRigidBody* each : row) {
    const double velocity = double(each->getLinearVelocity().dot(axis)) / it.speed;
    const double expected = each == row.back() ? 1 : 0;
    momentum += velocity;
    energy += double(each->getLinearVelocity().length2()) / (it.speed * it.speed);
    squares += (velocity - expected) * (velocity - expected);
  }
  const std::string name = Text(it.balls) + " balls of " + Text(it.radius) + " m, " + Text(it.speed) +
                           " m/s, gaps of " + Text(it.gap) + " steps";
  if (it.gap > 1) return {Sample{name + ": velocities", std::sqrt(squares), 0, 1, {}}};
  return {RelativeToTheory(name + ": momentum", momentum, 1), RelativeToTheory(name + ": energy", energy, 1)};
}

}  // namespace

Samples MeasureHeadOn(const Conditions& conditions) {
  return MeasureCases(conditions, HeadOnCases(), 7,
                      [](const Conditions& under, const HeadOn& it) { return MeasureHeadOn(under, it); });
}

Samples MeasureGas(const Conditions& conditions) {
  const double seconds = conditions.is_quick ? 1 : 4;
  const std::vector<Gas> all = {{Ground::kPlane, 60, seconds, 1},
                                {Ground::kBox, 60, seconds, 2},
                                {Ground::kBox, 50, seconds, 3},
                                {Ground::kPlane, 64, seconds, 4}};
  return MeasureCases(conditions, all, 3, [](const Conditions& under, const Gas& it) { return MeasureGas(under, it); });
}

Samples MeasureBounce(const Conditions& conditions) {
  return MeasureCases(conditions, BounceCases(), 7,
                      [](const Conditions& under, const Bounce& it) { return MeasureBounce(under, it); });
}

Samples MeasureObliqueBounce(const Conditions& conditions) {
  Samples samples;
  for (const ObliqueBounce& it : SelectCases(conditions, ObliqueBounceCases(), 5)) {
    AddTo(samples, MeasureObliqueBounce(conditions, it));
  }
  return samples;
}

Samples MeasureCradle(const Conditions& conditions) {
  Samples samples;
  for (const Cradle& it : SelectCases(conditions, CradleCases(), 3)) {
    AddTo(samples, MeasureCradle(conditions, it));
  }
  return samples;
}

}  // namespace dgd_physics
