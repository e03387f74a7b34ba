#include "physics/resting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "physics/lab.h"
#include "physics/multibody_world.h"

namespace dgd_physics {
namespace {

constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder, Form::kSphere};
constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh, Ground::kHeightfield};
constexpr std::array<double, 3> kHalves = {0.25, 0.1, 0.5};  // m
constexpr std::array<double, 3> kMasses = {1, 0.2, 30};      // kg

/// A body above ground. All forms come onto all grounds.
struct Drop {
  Form form;
  Ground ground;
  double half, mass;  // m, kg
  int index;

  std::string Name() const { return NameOf(form) + " " + Text(half) + " m on " + NameOf(ground); }
};

Drop DropOf(int index) {
  const std::size_t i = static_cast<std::size_t>(index);
  return {kForms[i % 4], kGrounds[(i + i / 4) % 4], kHalves[i % 3], kMasses[(i + i / 3) % 3], index};
}

/// Height of the rebound of a body that does not rebound, over that of the drop.
Sample MeasureDropDead(const Conditions& conditions, const Drop& drop) {
  constexpr std::array<double, 4> kDropHeights = {0.3, 2, 1, 0.5};  // m
  constexpr double kDuration = 0.7;                                 // s, after the impact.
  const double height = kDropHeights[static_cast<std::size_t>(drop.index / 2) % kDropHeights.size()];
  Lab lab(conditions);
  lab.AddGround(drop.ground, btTransform::getIdentity(), {}, Surface{.friction = 1, .restitution = 0});
  btConvexShape& shape = lab.MakeForm(drop.form, drop.half);
  const double start = height + PhaseOf(drop.index) * std::sqrt(2 * kGravity * height) * lab.dt();
  const btTransform pose = At(Vec(0.23, 0.31, FootOf(shape) + start), Yaw(HeadingOf(drop.index)));
  btRigidBody& body = lab.AddBody(shape, drop.mass, pose);
  lab.Run(std::sqrt(2 * start / kGravity) + 3 * lab.dt());
  double top = 0;
  for (int step = lab.StepsIn(kDuration); step > 0; --step) {
    lab.Step();
    top = std::max(top, HeightOf(body) - FootOf(shape));
  }
  return {drop.Name() + " from " + Text(start) + " m: rebound", top / start, 0, 1, NameOf(drop.form)};
}

/// Root mean square speed, of the centre and at the rim, long after a low and tilted drop; over 5 cm/s, below which the
/// benchmarks take a body to be at rest.
Sample MeasureRest(const Conditions& conditions, const Drop& drop) {
  constexpr double kSettleTime = 4, kMeasureTime = 1;  // s
  constexpr double kAtRest = 0.05;                     // m/s
  Lab lab(conditions);
  lab.AddGround(drop.ground, btTransform::getIdentity(), {}, Surface{.friction = 1, .restitution = 0});
  btConvexShape& shape = lab.MakeForm(drop.form, drop.half);
  const btQuaternion tilt(Direction(HeadingOf(drop.index)), btScalar(0.1));
  const btTransform pose = At(Vec(0.23, 0.31, FootOf(shape) + 0.2 * drop.half), tilt * Yaw(0.3 * drop.index));
  btRigidBody& body = lab.AddBody(shape, drop.mass, pose);
  lab.Run(kSettleTime);
  double squares = 0;
  const int steps = lab.StepsIn(kMeasureTime);
  for (int step = 0; step < steps; ++step) {
    lab.Step();
    squares += double(body.getLinearVelocity().length2()) +
               drop.half * drop.half * double(body.getAngularVelocity().length2());
  }
  return {drop.Name() + ": m/s", std::sqrt(squares / steps), 0, kAtRest, NameOf(drop.form)};
}

/// Mean force on a static body along z by all that touches it, over so many steps, N.
class Scale {
 public:
  explicit Scale(const btRigidBody& support) : support_(support) {}

  void Read(Lab& lab) {
    const btDispatcher& dispatcher = *lab.world().getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i);
      if (manifold.getBody0() != &support_ && manifold.getBody1() != &support_) continue;
      for (int j = 0; j < manifold.getNumContacts(); ++j) {
        const btManifoldPoint& point = manifold.getContactPoint(j);
        const btVector3 impulse = point.m_normalWorldOnB * point.m_appliedImpulse +
                                  point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1 +
                                  point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
        // On body 0; the support is pushed down.
        impulse_ += (manifold.getBody0() == &support_ ? -1 : 1) * double(impulse.z());
      }
    }
    seconds_ += lab.dt();
  }
  double Force() const { return impulse_ / seconds_; }

 private:
  const btRigidBody& support_;
  double impulse_ = 0, seconds_ = 0;
};

constexpr double kWeighSettleTime = 2, kWeighTime = 1;  // s

/// A plank across two ridges, with a load on it off the middle: force on each ridge, by the law of the lever.
Samples MeasurePlank(const Conditions& conditions, double offset, double load_mass, bool has_round_ridges, int index) {
  constexpr double kSpan = 0.8, kPlankMass = 2;                            // From the middle to a ridge, m; kg.
  constexpr double kRidge = 0.05, kHalfThickness = 0.03, kHalfLoad = 0.1;  // m
  Lab lab(conditions);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(HeadingOf(index)));
  btConvexShape& ridge = has_round_ridges
                             ? static_cast<btConvexShape&>(lab.Make<btCylinderShape>(Vec(kRidge, 0.4, kRidge)))
                             : lab.Make<btBoxShape>(Vec(0.1 * kRidge, 0.4, kRidge));
  std::vector<Scale> scales;
  for (const double side : {-1.0, 1.0})
    scales.emplace_back(lab.AddStatic(ridge, frame * At(Vec(side * kSpan, 0, -kRidge))));
  auto& plank = lab.Make<btBoxShape>(Vec(1, 0.2, kHalfThickness));
  auto& load = lab.Make<btBoxShape>(Vec(kHalfLoad, kHalfLoad, kHalfLoad));
  lab.AddBody(plank, kPlankMass, frame * At(Vec(0, 0, kHalfThickness)));
  lab.AddBody(load, load_mass, frame * At(Vec(offset, 0, 2 * kHalfThickness + kHalfLoad)));
  lab.Run(kWeighSettleTime);
  for (int step = lab.StepsIn(kWeighTime); step > 0; --step) {
    lab.Step();
    for (Scale& scale : scales) scale.Read(lab);
  }
  Samples samples;
  for (int i = 0; i < 2; ++i) {
    const double lever = (i == 0 ? kSpan - offset : kSpan + offset) / (2 * kSpan);
    samples.push_back(RelativeToTheory(
        "plank on " + std::string(has_round_ridges ? "rods" : "slats") + ", " + Text(load_mass) + " kg at " +
            Text(offset) + " m: " + (i == 0 ? "far" : "near") + " force, N",
        scales[static_cast<std::size_t>(i)].Force(), kGravity * (kPlankMass / 2 + load_mass * lever), "plank"));
  }
  return samples;
}

/// A plate on four balls, with a load on it off the middle: forces on the pair of balls at one side, for two sides.
Samples MeasurePlate(const Conditions& conditions, double offset_x, double offset_y, double load_mass, int index) {
  constexpr double kSpan = 0.4, kPlateMass = 2;                           // From the middle, along x and y, m; kg.
  constexpr double kBall = 0.1, kHalfThickness = 0.03, kHalfLoad = 0.08;  // m
  Lab lab(conditions);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(HeadingOf(index)));
  auto& ball = lab.Make<btSphereShape>(btScalar(kBall));
  std::vector<Scale> scales;
  for (const double x : {-kSpan, kSpan}) {
    for (const double y : {-kSpan, kSpan}) scales.emplace_back(lab.AddStatic(ball, frame * At(Vec(x, y, -kBall))));
  }
  lab.AddBody(lab.Make<btBoxShape>(Vec(0.5, 0.5, kHalfThickness)), kPlateMass, frame * At(Vec(0, 0, kHalfThickness)));
  lab.AddBody(lab.Make<btBoxShape>(Vec(kHalfLoad, kHalfLoad, kHalfLoad)), load_mass,
              frame * At(Vec(offset_x, offset_y, 2 * kHalfThickness + kHalfLoad)));
  lab.Run(kWeighSettleTime);
  for (int step = lab.StepsIn(kWeighTime); step > 0; --step) {
    lab.Step();
    for (Scale& scale : scales) scale.Read(lab);
  }
  const auto theory = [&](double offset) {
    return kGravity * (kPlateMass / 2 + load_mass * (kSpan + offset) / (2 * kSpan));
  };
  const std::string name =
      "plate on balls, " + Text(load_mass) + " kg at " + Text(offset_x) + ", " + Text(offset_y) + " m";
  return {RelativeToTheory(name + ": front force, N", scales[2].Force() + scales[3].Force(), theory(offset_x), "plate"),
          RelativeToTheory(name + ": left force, N", scales[1].Force() + scales[3].Force(), theory(offset_y), "plate")};
}

/// The place of the topmost of a stack of boxes after a while, against that of boxes that touch; over the stack's
/// height.
/// @param count  Of the boxes.
Samples MeasureStack(const Conditions& conditions, int count, double half, double mass_ratio, Ground ground, int index,
                     const std::string& group) {
  constexpr double kDuration = 5;  // s
  Lab lab(conditions);
  lab.AddGround(ground, btTransform::getIdentity(), {}, Surface{.friction = 1, .restitution = 0});
  auto& shape = lab.Make<btBoxShape>(Vec(half, 0.9 * half, 0.8 * half));
  const btTransform frame = At(Vec(0.23, 0.31, 0), Yaw(HeadingOf(index)));
  std::vector<const btRigidBody*> boxes;
  double mass = 1;
  for (int i = 0; i < count; ++i, mass *= mass_ratio) {
    const double height = (2 * i + 1) * 0.8 * half;
    boxes.push_back(&lab.AddBody(shape, mass, frame * At(Vec(0, 0, height), Yaw(0.2 * i))));
  }
  const btVector3 start = PositionOf(*boxes.back());
  lab.Run(kDuration);
  const btVector3 moved = (PositionOf(*boxes.back()) - start) / btScalar(2 * count * 0.8 * half);
  const std::string name =
      Text(count) + " boxes of " + Text(half) + " m, masses times " + Text(mass_ratio) + " on " + NameOf(ground);
  return {Sample{name + ": lower", -double(moved.z()), 0, 1, group},
          Sample{name + ": aside", std::hypot(double(moved.x()), double(moved.y())), 0, 1, group}};
}

/// The same for equal boxes, as multibodies, on a box.
Samples MeasureMultibodyStack(const Conditions& conditions, int count, double half, int index) {
  constexpr double kDuration = 5;  // s
  constexpr Surface kSurface = {.friction = 0.5, .restitution = 0};
  Lab lab(conditions);  // Owns the shapes.
  MultibodyWorld world(conditions);
  world.AddStatic(lab.Make<btBoxShape>(Vec(5, 5, 0.5)), At(Vec(0, 0, -0.5)), kSurface);
  auto& shape = lab.Make<btBoxShape>(Vec(half, half, half));
  std::vector<const btMultiBody*> boxes;
  for (int i = 0; i < count; ++i) {
    const btTransform pose = At(Vec(0.23, 0.31, (2 * i + 1) * half), Yaw(HeadingOf(index)));
    boxes.push_back(&world.AddBase(shape, 1, pose, kSurface));
  }
  const btMultiBody& top = *boxes.back();
  const btVector3 start = top.getBasePos();
  for (int step = lab.StepsIn(kDuration); step > 0; --step) world.Step();
  const btVector3 moved = (top.getBasePos() - start) / btScalar(2 * count * half);
  const std::string name = Text(count) + " multibodies of " + Text(half) + " m";
  return {Sample{name + ": lower", -double(moved.z()), 0, 1, "multibodies"},
          Sample{name + ": aside", std::hypot(double(moved.x()), double(moved.y())), 0, 1, "multibodies"}};
}

struct Shot {
  Form form;
  Ground plate;            // A box of the thickness, or a mesh.
  double half, thickness;  // m
  double speed;            // m/s
  int index;
  bool is_swept = false;  // Whether it is the plate that moves, by the app, and the body that is at rest.
};

bool GoesThrough(const Conditions& conditions, const Shot& shot, double phase) {
  constexpr double kRange = 1;  // m
  Lab lab(conditions, 0);
  // At an angle to all axes.
  const btQuaternion turn(Vec(0.6, 0.48, 0.64), btScalar(0.7 + shot.index));
  const btTransform frame = At(Vec(0, 0, 0), turn);
  if (shot.plate == Ground::kBox) {
    lab.AddStatic(lab.Make<btBoxShape>(Vec(2, 2, shot.thickness / 2)), frame * At(Vec(0, 0, -shot.thickness / 2)),
                  {1, 0});
  } else {
    lab.AddGround(shot.plate, frame, {.cells = 8, .pitch = 0.5}, Surface{1, 0});
  }
  const double start = kRange + phase * shot.speed * lab.dt();
  btRigidBody& body = lab.AddBody(lab.MakeForm(shot.form, shot.half), 1, frame * At(Vec(0.13, 0.21, start)));
  body.setLinearVelocity(quatRotate(turn, Vec(0, 0, -shot.speed)));
  lab.Run((start + kRange) / shot.speed + 0.05);
  return double((frame.inverse() * PositionOf(body)).z()) < -shot.thickness / 2;
}

/// Whether the plate, which is to carry the body along, leaves it behind.
bool SweepsPast(const Conditions& conditions, const Shot& shot, double phase) {
  constexpr double kRange = 0.5, kWay = 1.5;  // m
  Lab lab(conditions, 0);
  const btTransform frame = At(Vec(0, 0, 0), btQuaternion(Vec(0.64, 0.6, 0.48), btScalar(0.4 + shot.index)));
  btConvexShape& shape = lab.MakeForm(shot.form, shot.half);
  const double start = -FootOf(shape) - kRange - phase * shot.speed * lab.dt();
  const auto top_at = [&](double time) { return start + shot.speed * time; };
  const auto pose_at = [&](double time) { return frame * At(Vec(0, 0, top_at(time) - shot.thickness / 2)); };
  btRigidBody& plate = lab.AddKinematic(lab.Make<btBoxShape>(Vec(2, 2, shot.thickness / 2)), pose_at(0), Surface{1, 0});
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(Vec(0.13, 0.21, 0)));
  const double duration = kWay / shot.speed;
  lab.RunMoving(plate, duration, pose_at);
  const double top = top_at(lab.StepsIn(duration) * lab.dt());
  return double((frame.inverse() * PositionOf(body)).z()) < top;
}

/// Share of shots that go through, at moments spread over a step.
Sample MeasureTunnel(const Conditions& conditions, const Shot& shot) {
  const int count = conditions.is_quick ? 4 : 8;
  int through = 0;
  for (int i = 0; i < count; ++i) {
    const double phase = (i + PhaseOf(shot.index)) / count;
    if (shot.is_swept ? SweepsPast(conditions, shot, phase) : GoesThrough(conditions, shot, phase)) ++through;
  }
  const std::string plate = shot.plate == Ground::kBox ? "plate of " + Text(shot.thickness) + " m" : NameOf(shot.plate);
  return {NameOf(shot.form) + " " + Text(shot.half) + " m at " + Text(shot.speed) + " m/s through " +
              (shot.is_swept ? "swept " : "") + plate,
          through / double(count), 0, 1,
          shot.is_swept                ? "swept plates"
          : shot.plate == Ground::kBox ? "plates"
                                       : "meshes"};
}

std::vector<Shot> Shots() {
  constexpr std::array<double, 3> kSpeeds = {20, 50, 100};                                              // m/s
  constexpr std::array<std::array<double, 2>, 3> kSizes = {{{0.02, 0.01}, {0.05, 0.02}, {0.1, 0.05}}};  // m
  std::vector<Shot> shots;
  for (const double speed : kSpeeds) {
    for (const auto& [half, thickness] : kSizes) {
      for (const Form form : kForms) {
        const std::size_t i = shots.size();
        shots.push_back({form, i % 5 == 4 ? Ground::kMesh : Ground::kBox, half, thickness, speed, static_cast<int>(i)});
      }
    }
  }
  return shots;
}

/// Plates as fast as apps move things.
std::vector<Shot> SweptShots() {
  constexpr std::array<double, 3> kSpeeds = {4, 8, 20};  // m/s
  std::vector<Shot> shots;
  for (Shot shot : Shots()) {
    if (shot.index % 2 != 0) continue;
    shot.plate = Ground::kBox;
    shot.is_swept = true;
    shot.speed = kSpeeds[static_cast<std::size_t>(shot.index / 2) % kSpeeds.size()];
    shots.push_back(shot);
  }
  return shots;
}

}  // namespace

Samples MeasureDropDead(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 64, 11)) samples.push_back(MeasureDropDead(conditions, DropOf(i)));
  return samples;
}

Samples MeasureRest(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 48, 11)) {
    const Drop drop = DropOf(i);
    if (drop.form != Form::kSphere) samples.push_back(MeasureRest(conditions, drop));
  }
  for (const int i : SelectIndices(conditions, 32, 11)) {
    Drop drop = DropOf(i);
    drop.form = kSupportForms[static_cast<std::size_t>(i) % 4];
    samples.push_back(MeasureRest(conditions, drop));
  }
  return samples;
}

Samples MeasureWeight(const Conditions& conditions) {
  constexpr std::array<double, 4> kOffsets = {0.3, 0.6, 0.1, -0.5};  // m
  constexpr std::array<double, 3> kLoads = {1, 6, 0.3};              // kg
  Samples samples;
  for (const int i : SelectIndices(conditions, 8, 3)) {
    const std::size_t j = static_cast<std::size_t>(i);
    AddTo(samples, MeasurePlank(conditions, kOffsets[j % 4], kLoads[j % 3], i % 2 == 0, i));
    AddTo(samples, MeasurePlate(conditions, 0.5 * kOffsets[j % 4], 0.4 * kOffsets[(j + 1) % 4], kLoads[j % 3], i));
  }
  return samples;
}

Samples MeasureStack(const Conditions& conditions) {
  constexpr std::array<double, 3> kMassRatios = {1, 0.7, 1.4};
  Samples samples;
  for (const int i : SelectIndices(conditions, 9, 4)) {
    const std::size_t j = static_cast<std::size_t>(i);
    AddTo(samples,
          MeasureStack(conditions, 5, kHalves[j % 3], kMassRatios[(j + j / 3) % 3], kGrounds[j % 2], i, "five"));
  }
  // Free fall takes these through a fiftieth of their size in a step at 60 Hz.
  constexpr std::array<double, 3> kSmallHalves = {0.08, 0.1, 0.15};
  for (const int i : SelectIndices(conditions, 6, 3)) {
    const std::size_t j = static_cast<std::size_t>(i);
    AddTo(samples, MeasureStack(conditions, 2 + i % 2, kSmallHalves[j % 3], 1, kGrounds[j % 2], i, "small"));
  }
  for (const int i : SelectIndices(conditions, 6, 5)) {
    const std::size_t j = static_cast<std::size_t>(i);
    AddTo(samples, MeasureMultibodyStack(conditions, 3 + i % 3 * 3, kSmallHalves[j / 2 % 3], i));
  }
  // The uppermost weighs 10 to 200 times the lowest.
  constexpr std::array<double, 4> kHeavyRatios = {200, 10, 50, 100};
  for (const int i : SelectIndices(conditions, 8, 4)) {
    const std::size_t j = static_cast<std::size_t>(i);
    const int count = 2 + i % 2;
    AddTo(samples, MeasureStack(conditions, count, kHalves[j % 3], std::pow(kHeavyRatios[j / 2], 1.0 / (count - 1)),
                                kGrounds[j % 2], i, "heavy on light"));
  }
  return samples;
}

Samples MeasureTunnel(const Conditions& conditions) {
  const auto measure = [](const Conditions& under, const Shot& it) { return MeasureTunnel(under, it); };
  Samples samples = MeasureCases(conditions, Shots(), 7, measure);
  AddTo(samples, MeasureCases(conditions, SweptShots(), 7, measure));
  return samples;
}

}  // namespace dgd_physics
