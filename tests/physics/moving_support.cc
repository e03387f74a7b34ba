#include "physics/moving_support.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "physics/coulomb.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

constexpr double kSettleTime = 0.5;        // s
constexpr double kSupportHalfDepth = 0.5;  // m

/// A body on a support.
struct Load {
  Form form;
  double half;  // m
  double mass;  // kg
  double friction;
  double heading;  // Along which the support moves, radians.

  std::string Name() const {
    return NameOf(form) + " " + Text(half) + " m, mu " + Text(friction) + ", heading " + Text(heading);
  }
  std::string Group() const { return form == Form::kBox ? "boxes" : "others"; }
};

Load LoadOf(int index) {
  constexpr std::array kForms = {Form::kBox, Form::kBox, Form::kHull, Form::kBox, Form::kCylinder};
  constexpr std::array<double, 3> kHalves = {0.25, 0.1, 0.5};
  constexpr std::array<double, 3> kMasses = {1, 0.2, 30};
  constexpr std::array<double, 3> kFrictions = {0.5, 0.3, 0.8};
  const std::size_t i = static_cast<std::size_t>(index);
  return {kForms[i % 5], kHalves[(i + i / 3) % 3], kMasses[(i + i / 2) % 3], kFrictions[i / 2 % 3], HeadingOf(index)};
}

btRigidBody& AddLoad(Lab& lab, const Load& load) {
  btConvexShape& shape = lab.MakeForm(load.form, load.half);
  return lab.AddBody(shape, load.mass, At(Vec(0.1, -0.2, FootOf(shape)), Yaw(0.7 * load.heading)),
                     Surface{.friction = load.friction});
}

btBoxShape& MakeSupport(Lab& lab) { return lab.Make<btBoxShape>(Vec(8, 8, kSupportHalfDepth)); }
btTransform SupportPose(const btVector3& moved) { return At(moved - Vec(0, 0, kSupportHalfDepth)); }

/// How a belt comes by its speed; it does not move.
enum class BeltDrive {
  kTickCallback,     ///< A kinematic body whose velocity the app sets before each step, in Bullet's pre-tick callback.
  kPreviousPose,     ///< A kinematic body whose last pose the app sets back, so that Bullet computes its velocity.
  kContactCallback,  ///< A static body whose contacts the app gives a surface velocity when they are added.
};

const char* NameOf(BeltDrive drive) {
  switch (drive) {
    case BeltDrive::kTickCallback:
      return "tick callback";
    case BeltDrive::kPreviousPose:
      return "previous pose";
    default:
      return "contact callback";
  }
}

/// What the callbacks of the belt that runs refer to.
struct Belt {
  btRigidBody* body = nullptr;
  btVector3 velocity = Vec(0, 0, 0);
};

void SetBeltVelocity(btDynamicsWorld* world, btScalar) {
  const Belt& belt = *static_cast<const Belt*>(world->getWorldUserInfo());
  belt.body->setLinearVelocity(belt.velocity);
}

/// As Bullet's users make conveyors. The surface velocity is that of the second body against the first, along the
/// first friction direction.
bool MoveSurface(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int,
                 const btCollisionObjectWrapper* second, int, int) {
  for (const btCollisionObject* object : {first->getCollisionObject(), second->getCollisionObject()}) {
    const Belt* belt = static_cast<const Belt*>(object->getUserPointer());
    if (belt == nullptr) continue;
    const btScalar speed = belt->velocity.length();
    point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
    point.m_lateralFrictionDir1 = belt->velocity / speed;
    point.m_lateralFrictionDir2 = point.m_normalWorldOnB.cross(point.m_lateralFrictionDir1);
    point.m_contactMotion1 = object == second->getCollisionObject() ? speed : -speed;
  }
  return true;
}

/// Sets Bullet's global callback as long as it lives.
class ContactAddedGuard {
 public:
  explicit ContactAddedGuard(ContactAddedCallback callback) : before_(gContactAddedCallback) {
    gContactAddedCallback = callback;
  }
  ~ContactAddedGuard() { gContactAddedCallback = before_; }
  ContactAddedGuard(const ContactAddedGuard&) = delete;
  ContactAddedGuard& operator=(const ContactAddedGuard&) = delete;

 private:
  ContactAddedCallback before_;
};

void Drive(Lab& lab, BeltDrive drive, Belt& belt) {
  if (drive == BeltDrive::kTickCallback) lab.world().setInternalTickCallback(SetBeltVelocity, &belt, true);
  if (drive == BeltDrive::kContactCallback) {
    belt.body->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    belt.body->setUserPointer(&belt);
    // Without these Bullet computes its own friction directions.
    lab.world().getSolverInfo().m_solverMode |=
        SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
  }
}

void StepBelt(Lab& lab, BeltDrive drive, const Belt& belt) {
  if (drive == BeltDrive::kPreviousPose) {
    btTransform previous = belt.body->getWorldTransform();
    previous.setOrigin(previous.getOrigin() - belt.velocity * btScalar(lab.dt()));
    belt.body->setInterpolationWorldTransform(previous);
  }
  lab.Step();
}

/// Mean velocity along the belt after the load must have caught up, over the belt's.
Sample MeasureBelt(const Conditions& conditions, const Load& load, BeltDrive drive, double speed) {
  constexpr double kMeasureTime = 0.5;  // s
  const ContactAddedGuard guard(MoveSurface);
  Lab lab(conditions);
  Belt belt{&lab.AddKinematic(MakeSupport(lab), SupportPose(Vec(0, 0, 0))), Direction(load.heading) * btScalar(speed)};
  btRigidBody& body = AddLoad(lab, load);
  Drive(lab, drive, belt);
  const int caught_up = lab.StepsIn(kSettleTime + 1.5 * speed / (load.friction * kGravity));
  const int measured = lab.StepsIn(kMeasureTime);
  btVector3 start = PositionOf(body);
  for (int step = 0; step < caught_up + measured; ++step) {
    if (step == caught_up) start = PositionOf(body);
    StepBelt(lab, drive, belt);
  }
  const double way = Along(PositionOf(body) - start, load.heading);
  return RelativeToTheory(load.Name() + ", belt by " + NameOf(drive) + ", " + Text(speed) + " m/s",
                          way / (measured * lab.dt()) / speed, 1, load.Group());
}

/// Share of the support's way by which the load is dragged along, when it is put aside without a velocity.
Sample MeasureTeleport(const Conditions& conditions, const Load& load, bool is_kinematic, double offset) {
  constexpr int kRepeats = 10;
  constexpr double kPause = 0.1;  // s
  Lab lab(conditions);
  btRigidBody& support = is_kinematic ? lab.AddKinematic(MakeSupport(lab), SupportPose(Vec(0, 0, 0)))
                                      : lab.AddStatic(MakeSupport(lab), SupportPose(Vec(0, 0, 0)));
  btRigidBody& body = AddLoad(lab, load);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  for (int i = 1; i <= kRepeats; ++i) {
    const btTransform pose = SupportPose(Direction(load.heading) * btScalar(i * offset));
    support.setWorldTransform(pose);
    support.setInterpolationWorldTransform(pose);  // No velocity.
    lab.Run(kPause);
  }
  return {load.Name() + (is_kinematic ? ", kinematic" : ", static") + " support put aside by " + Text(offset) + " m",
          Along(PositionOf(body) - start, load.heading) / (kRepeats * offset), 0, 1, load.Group()};
}

/// Way of a platform along x of its heading, and up, by time; from rest.
struct Motion {
  std::string name;
  double frequency;                // Hz
  double forward, second, upward;  // Amplitudes of the first and second harmonic, and of the rise, m.

  double Phase(double time) const { return 2 * kPi * frequency * time; }
  double Forward(double time) const {
    return forward * (1 - std::cos(Phase(time))) + second * (1 - std::cos(2 * Phase(time)));
  }
  double Upward(double time) const { return upward * (1 - std::cos(Phase(time))); }
  double ForwardAcceleration(double time) const {
    const double rate = 2 * kPi * frequency;
    return rate * rate * (forward * std::cos(Phase(time)) + 4 * second * std::cos(2 * Phase(time)));
  }
  double UpwardAcceleration(double time) const {
    const double rate = 2 * kPi * frequency;
    return rate * rate * upward * std::cos(Phase(time));
  }
};

/// Moves a kinematic platform by its pose, as apps do, and calls visit(time) after each step.
template <class Visit>
void Shake(Lab& lab, btRigidBody& platform, const Motion& motion, double heading, double duration, const Visit& visit) {
  const int steps = lab.StepsIn(duration);
  for (int step = 1; step <= steps; ++step) {
    const double time = step * lab.dt();
    platform.setWorldTransform(
        SupportPose(Direction(heading) * btScalar(motion.Forward(time)) + Vec(0, 0, motion.Upward(time))));
    lab.Step();
    visit(time);
  }
}

/// A platform that friction can follow: the load's amplitude over the platform's, and its phase behind it in radians.
Samples MeasurePlatform(const Conditions& conditions, const Load& load, const Motion& motion) {
  constexpr double kStartTime = 1, kMeasureTime = 1;  // s; whole periods.
  Lab lab(conditions);
  btRigidBody& platform = lab.AddKinematic(MakeSupport(lab), SupportPose(Vec(0, 0, 0)));
  btRigidBody& body = AddLoad(lab, load);
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  std::complex<double> of_load = 0, of_platform = 0;
  Shake(lab, platform, motion, load.heading, kStartTime + kMeasureTime, [&](double time) {
    if (time < kStartTime + 0.5 * lab.dt()) return;
    const std::complex<double> turning = std::polar(1.0, -motion.Phase(time));
    of_load += Along(PositionOf(body) - start, load.heading) * turning;
    of_platform += motion.Forward(time) * turning;
  });
  const std::complex<double> ratio = of_load / of_platform;
  const std::string name = load.Name() + ", " + motion.name;
  return {RelativeToTheory(name + ": amplitude", std::abs(ratio), 1, load.Group()),
          Sample{name + ": phase, rad", std::arg(ratio), 0, 1, load.Group()}};
}

/// A platform on which the load slips forth more than back: speed of transport.
Sample MeasureFeeder(const Conditions& conditions, const Load& load, const Motion& motion) {
  constexpr double kStartTime = 1, kMeasureTime = 2;  // s; whole periods.
  Slip started;
  const Slip ended = IntegrateSlip(
      kStartTime + kMeasureTime, [&](double time) { return -motion.ForwardAcceleration(time); },
      [&](double time) { return load.friction * (kGravity + motion.UpwardAcceleration(time)); },
      [&](double time, const Slip& slip) {
        if (time <= kStartTime) started = slip;
      });
  Lab lab(conditions);
  btRigidBody& platform = lab.AddKinematic(MakeSupport(lab), SupportPose(Vec(0, 0, 0)));
  btRigidBody& body = AddLoad(lab, load);
  lab.Run(kSettleTime);
  btVector3 from = PositionOf(body);
  Shake(lab, platform, motion, load.heading, kStartTime + kMeasureTime, [&](double time) {
    if (time < kStartTime + 0.5 * lab.dt()) from = PositionOf(body);
  });
  return RelativeToTheory(load.Name() + ", " + motion.name + ": m/s",
                          Along(PositionOf(body) - from, load.heading) / kMeasureTime,
                          (ended.way - started.way) / kMeasureTime, load.Group());
}

/// With this acceleration at most forward, by the first harmonic and the second alike, or along a slanted line.
Motion TwoHarmonics(double frequency, double acceleration) {
  const double rate = 2 * kPi * frequency, amplitude = acceleration / 2 / (rate * rate);
  return {Text(frequency) + " Hz, two harmonics", frequency, amplitude, amplitude / 4, 0};
}
Motion Slanted(double frequency, double upward_acceleration, double slope) {
  const double rate = 2 * kPi * frequency, upward = upward_acceleration / (rate * rate);
  return {Text(frequency) + " Hz, slanted", frequency, upward / std::tan(slope), 0, upward};
}

}  // namespace

Samples MeasurePlatform(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 16, 7)) {
    const double frequency = i % 2 == 0 ? 6 : 3;
    const Motion motion = {Text(frequency) + " Hz", frequency, i % 4 < 2 ? 2e-3 : 2e-4, 0, 0};
    AddTo(samples, MeasurePlatform(conditions, LoadOf(i), motion));
  }
  return samples;
}

Samples MeasureFeeder(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 16, 7)) {
    Load load = LoadOf(i);
    load.form = i % 4 == 3 ? Form::kCylinder : Form::kBox;
    const double frequency = i % 4 < 2 ? 10 : 5;
    const Motion motion =
        i % 2 == 0 ? TwoHarmonics(frequency, 2.2 * load.friction * kGravity) : Slanted(frequency, 0.7 * kGravity, 0.5);
    samples.push_back(MeasureFeeder(conditions, load, motion));
  }
  return samples;
}

Samples MeasureBelt(const Conditions& conditions) {
  constexpr std::array<double, 6> kSpeeds = {0.002, 0.5, 0.05, 1, 0.01, 0.1};  // m/s
  constexpr std::array kDrives = {BeltDrive::kTickCallback, BeltDrive::kPreviousPose, BeltDrive::kContactCallback};
  Samples samples;
  for (const int i : SelectIndices(conditions, 36, 7)) {
    const std::size_t j = static_cast<std::size_t>(i);
    samples.push_back(MeasureBelt(conditions, LoadOf(i), kDrives[(j + j / 6) % 3], kSpeeds[j % 6]));
  }
  return samples;
}

Samples MeasureTeleport(const Conditions& conditions) {
  Samples samples;
  for (const int i : SelectIndices(conditions, 20, 7)) {
    samples.push_back(MeasureTeleport(conditions, LoadOf(i), i % 2 == 1, i % 4 < 2 ? 1e-4 : 3e-5));
  }
  return samples;
}

}  // namespace dgd_physics
