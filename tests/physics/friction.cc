#include "physics/friction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/coulomb.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder};
constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh};
constexpr std::array<double, 3> kFrictions = {0.3, 0.5, 0.2};
constexpr std::array<double, 3> kHalves = {0.25, 0.1, 0.5};  // m
constexpr std::array<double, 3> kMasses = {1, 0.2, 30};      // kg
constexpr double kSettleTime = 0.5;                          // s

/// A body that rests on the ground and is about to be pushed along a heading.
struct Block {
  Form form = Form::kBox;
  Ground ground = Ground::kBox;
  double half = 0.25;  // m
  double mass = 1;     // kg
  double friction = 0.5;
  double heading = 0;  // rad

  std::string Name() const {
    return NameOf(form) + " " + Text(half) + " m on " + NameOf(ground) + ", mu " + Text(friction) + ", heading " +
           Text(heading);
  }
  std::string Group() const {
    if (IsSupportForm(form)) return NameOf(form);
    return form == Form::kBox && ground == Ground::kBox ? "boxes on boxes" : "others";
  }
};

/// Every combination of form and ground comes by; sizes, masses, friction and headings change along.
Block BlockOf(int index) {
  const std::size_t i = static_cast<std::size_t>(index);
  return {kForms[i % 3],         kGrounds[i / 3 % 3], kHalves[(i + i / 3) % 3], kMasses[(i + i / 9) % 3],
          kFrictions[i / 2 % 3], HeadingOf(index)};
}

/// Boxes alone, every other one on a box, the others on planes.
Block BoxOf(int index) {
  Block block = BlockOf(index);
  block.form = Form::kBox;
  block.ground = index % 2 == 0 ? Ground::kBox : Ground::kPlane;
  return block;
}

btRigidBody& AddBlock(Lab& lab, const Block& block) {
  btConvexShape& shape = lab.MakeForm(block.form, block.half);
  // Off the middle of the ground's squares; turned otherwise than it will move.
  const btVector3 position = Vec(0.23, 0.31, FootOf(shape));
  return lab.AddBody(shape, block.mass, At(position, Yaw(0.7 * block.heading)), Surface{.friction = block.friction});
}

/// Sets a block off. Bullet moves a body by its velocity at the end of each step, which is the true one half a step
/// later: with half a step's loss added, all later positions of a uniformly slowed body are the true ones.
void Kick(const Lab& lab, btRigidBody& body, double speed, double heading, double deceleration) {
  body.setLinearVelocity(body.getLinearVelocity() +
                         Direction(heading) * btScalar(speed + 0.5 * deceleration * lab.dt()));
}

double SlideDistance(double speed, double deceleration) { return 0.5 * speed * speed / deceleration; }

Sample MeasureSlide(const Conditions& conditions, const Block& block, double speed) {
  Lab lab(conditions);
  lab.AddGround(block.ground);
  btRigidBody& body = AddBlock(lab, block);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  const double deceleration = block.friction * kGravity;
  Kick(lab, body, speed, block.heading, deceleration);
  lab.Run(speed / deceleration + 0.3);
  return RelativeToTheory(block.Name() + ", " + Text(speed) + " m/s", Along(PositionOf(body) - start, block.heading),
                          SlideDistance(speed, deceleration), block.Group());
}

/// One after another, each after the last has ended: speeds from 0.06 to 0.25 m/s.
Sample MeasureTaps(const Conditions& conditions, const Block& block) {
  constexpr int kTaps = 20;
  Lab lab(conditions);
  lab.AddGround(block.ground);
  btRigidBody& body = AddBlock(lab, block);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  const double deceleration = block.friction * kGravity;
  double distance = 0;
  for (int tap = 0; tap < kTaps; ++tap) {
    const double speed = 0.06 + 0.19 * PhaseOf(tap);
    Kick(lab, body, speed, block.heading, deceleration);
    distance += SlideDistance(speed, deceleration);
    lab.Run(speed / deceleration + 0.1);
  }
  return RelativeToTheory(block.Name(), Along(PositionOf(body) - start, block.heading), distance, block.Group());
}

/// Farthest and last way from the start.
struct Swing {
  double farthest = 0;
  double last = 0;  // Signed.

  void Visit(double way) {
    farthest = std::max(farthest, std::abs(way));
    last = way;
  }
};

Samples MeasureSwingForce(const Conditions& conditions, const Block& block, double frequency) {
  constexpr double kOverload = 1.5;  // Of the greatest force, over friction's.
  constexpr double kDuration = 2;    // s; whole periods.
  const double friction = block.friction * kGravity;
  const auto drive = [&](double time) { return kOverload * friction * std::sin(2 * kPi * frequency * time); };
  Swing theory;
  IntegrateSlip(
      kDuration, drive, [friction](double) { return friction; },
      [&theory](double, const Slip& slip) { theory.Visit(slip.way); });

  Lab lab(conditions);
  lab.AddGround(block.ground);
  btRigidBody& body = AddBlock(lab, block);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  Swing measured;
  for (int step = 0; step < lab.StepsIn(kDuration); ++step) {
    const double force = block.mass * drive((step + 0.5) * lab.dt());
    body.applyCentralForce(Direction(block.heading) * btScalar(force));
    lab.Step();
    measured.Visit(Along(PositionOf(body) - start, block.heading));
  }
  const std::string name = block.Name() + ", " + Text(frequency) + " Hz";
  return {RelativeToTheory(name + ": farthest", measured.farthest, theory.farthest, block.Group()),
          Sample{name + ": last", measured.last, theory.last, theory.farthest, block.Group()}};
}

/// Ground tilted by `slope`, so that the block would slide along the heading.
struct Slope {
  btTransform frame;
  btVector3 downhill;  // World.
};

Slope MakeSlope(double slope, double heading) {
  const btVector3 horizontal = Direction(heading);
  const btQuaternion turn(Vec(0, 0, 1).cross(horizontal), btScalar(slope));
  return {At(Vec(0, 0, 0), turn), quatRotate(turn, horizontal)};
}

btRigidBody& AddBlockOnSlope(Lab& lab, const Block& block, const Slope& slope) {
  lab.AddGround(block.ground, slope.frame, {.cells = 40});
  btConvexShape& shape = lab.MakeForm(block.form, block.half);
  const btTransform pose = slope.frame * At(Vec(0.23, 0.31, FootOf(shape)), Yaw(0.7 * block.heading));
  return lab.AddBody(shape, block.mass, pose, Surface{.friction = block.friction});
}

/// Way in five seconds on a slope that holds, relative to 1 cm: a box that creeps by 2 mm/s has lost all its marks.
Sample MeasureHold(const Conditions& conditions, const Block& block, double share) {
  constexpr double kDuration = 5;       // s
  constexpr double kCreepScale = 0.01;  // m
  const double angle = share * std::atan(block.friction);
  const Slope slope = MakeSlope(angle, block.heading);
  Lab lab(conditions);
  btRigidBody& body = AddBlockOnSlope(lab, block, slope);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  lab.Run(kDuration);
  const double way = double((PositionOf(body) - start).length());
  return {block.Name() + ", held at " + Text(angle) + " rad", way, 0, kCreepScale, block.Group()};
}

/// Speed after a second on a slope that does not hold.
Sample MeasureDescent(const Conditions& conditions, const Block& block, double excess) {
  constexpr double kDuration = 1;  // s
  const double angle = std::atan(block.friction) + excess;
  const Slope slope = MakeSlope(angle, block.heading);
  Lab lab(conditions);
  btRigidBody& body = AddBlockOnSlope(lab, block, slope);
  lab.Run(kDuration);
  const double speed = double(body.getLinearVelocity().dot(slope.downhill));
  const double acceleration = kGravity * (std::sin(angle) - block.friction * std::cos(angle));
  const double duration = lab.StepsIn(kDuration) * lab.dt();
  return RelativeToTheory(block.Name() + ", slides at " + Text(angle) + " rad", speed, acceleration * duration,
                          block.Group());
}

/// A box that spins about the vertical slides at its four corners, all as far from the axis: whatever the share of the
/// weight that each bears, friction brakes it by mu m g times that distance. Angle until it stops.
Sample MeasureTorsion(const Conditions& conditions, const Block& block, double spin) {
  Lab lab(conditions);
  lab.AddGround(block.ground);
  btRigidBody& body = AddBlock(lab, block);
  lab.Run(kSettleTime);
  const auto& box = static_cast<const btBoxShape&>(ShapeOf(body));
  const btVector3 half = box.getHalfExtentsWithMargin();
  const double arm = std::hypot(double(half.x()), double(half.y()));
  const double deceleration = block.friction * block.mass * kGravity * arm * double(body.getInvInertiaDiagLocal().z());
  // As in Kick().
  body.setAngularVelocity(Vec(0, 0, spin + 0.5 * deceleration * lab.dt()));
  double angle = 0;
  for (int step = lab.StepsIn(spin / deceleration + 0.3); step > 0; --step) {
    lab.Step();
    angle += double(body.getAngularVelocity().z()) * lab.dt();
  }
  return RelativeToTheory(block.Name() + ", " + Text(spin) + " rad/s: rad", angle, SlideDistance(spin, deceleration),
                          block.Group());
}

}  // namespace

Samples MeasureTorsion(const Conditions& conditions) {
  constexpr std::array<double, 5> kSpins = {2, 10, 0.5, 5, 1};  // rad/s
  Samples samples;
  for (const int i : SelectIndices(conditions, 20, 7)) {
    samples.push_back(MeasureTorsion(conditions, BoxOf(i), kSpins[static_cast<std::size_t>(i) % kSpins.size()]));
  }
  return samples;
}

Samples MeasureSlide(const Conditions& conditions) {
  constexpr std::array<double, 7> kSpeeds = {0.05, 1, 0.2, 3, 0.1, 0.4, 2};  // m/s
  Samples samples;
  for (const int i : SelectIndices(conditions, 72, 11)) {
    const Block block = i % 4 == 3 ? BoxOf(2 * i) : BlockOf(i);
    samples.push_back(MeasureSlide(conditions, block, kSpeeds[static_cast<std::size_t>(i) % kSpeeds.size()]));
  }
  return samples;
}

Samples MeasureSwingForce(const Conditions& conditions) {
  constexpr std::array<double, 4> kFrequencies = {2, 10, 5, 3};  // Hz
  Samples samples;
  for (const int i : SelectIndices(conditions, 20, 7)) {
    const Block block = BoxOf(i);
    const double frequency = kFrequencies[static_cast<std::size_t>(i + i / 4) % kFrequencies.size()];
    AddTo(samples, MeasureSwingForce(conditions, block, frequency));
  }
  return samples;
}

Samples MeasureTaps(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 18, 5)) {
    samples.push_back(MeasureTaps(conditions, i % 3 == 2 ? BlockOf(i) : BoxOf(i)));
  }
  return samples;
}

Samples MeasureIncline(const Conditions& conditions) {
  constexpr std::array<double, 3> kShares = {0.4, 0.8, 0.95};     // Of the friction angle.
  constexpr std::array<double, 3> kExcesses = {0.05, 0.15, 0.3};  // Over it, radians.
  Samples samples;
  for (const int i : SelectIndices(conditions, 24, 7)) {
    const std::size_t j = static_cast<std::size_t>(i);
    const Block held = i % 3 == 2 ? BoxOf(2 * i) : BlockOf(i), sliding = i % 3 == 1 ? BoxOf(2 * i) : BlockOf(i + 4);
    samples.push_back(MeasureHold(conditions, held, kShares[j % 3]));
    samples.push_back(MeasureDescent(conditions, sliding, kExcesses[(j + j / 3) % 3]));
  }
  for (const int i : SelectIndices(conditions, 24, 11)) {
    const std::size_t j = static_cast<std::size_t>(i);
    Block block = BlockOf(i + i / 12);
    block.form = kSupportForms[j % 4];
    samples.push_back(MeasureHold(conditions, block, kShares[(j + j / 3) % 3]));
    samples.push_back(MeasureDescent(conditions, block, kExcesses[(j + j / 4) % 3]));
  }
  return samples;
}

}  // namespace dgd_physics
