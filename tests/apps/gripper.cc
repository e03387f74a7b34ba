// A two-finger gripper, as robot simulators build it of a btMultiBody, picks a part of 1 to 4 cm off the table, lifts
// it, holds it and swings it.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <memory>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

/// A world of multibodies on either narrowphase.
struct RobotWorld {
  explicit RobotWorld(Narrowphase narrowphase)
      : dispatching(narrowphase == Narrowphase::kOurs ? dgd_test::Route::kConfiguration : dgd_test::Route::kBuiltin),
        world(&dispatching.dispatcher(), &broadphase, &solver, &dispatching.configuration()) {
    world.setGravity(Vec(0, 0, -kGravity));
  }

  dgd_test::Dispatching dispatching;
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world;
};

constexpr double kFingerMass = 0.2, kGripForce = 3;  // kg, N
constexpr double kFingerHalfThickness = 0.005;       // m
constexpr double kReach = 0.04;                      // Of the fingers' centres below the palm's, m.

/// A palm that moves up and down, with two fingers that close along x.
class RobotGripper {
 public:
  /// @param opening  Between each finger's face and the middle, m.
  RobotGripper(RobotWorld& robot, double height, double opening, double dt)
      : world_(robot.world),
        opening_(opening),
        body_(3, btScalar(1), Vec(1, 1, 1), /*fixedBase=*/true, /*canSleep=*/false),
        palm_shape_(Vec(0.06, 0.02, 0.01)),
        finger_shape_(Vec(kFingerHalfThickness, 0.01, 0.02)) {
    const btQuaternion none = btQuaternion::getIdentity();
    const btVector3 zero = Vec(0, 0, 0), inertia = Vec(1e-4, 1e-4, 1e-4);
    body_.setupPrismatic(0, btScalar(1), inertia, -1, none, Vec(0, 0, 1), zero, zero, true);
    for (const int side : {-1, 1}) {
      const btVector3 place = Vec(side * (opening + kFingerHalfThickness), 0, -kReach);
      body_.setupPrismatic(side < 0 ? 1 : 2, btScalar(kFingerMass), inertia, 0, none, Vec(-side, 0, 0), place, zero,
                           true);
    }
    body_.setBasePos(Vec(0, 0, height + kReach));
    body_.finalizeMultiDof();
    body_.setHasSelfCollision(false);
    world_.addMultiBody(&body_);
    // Bullet solves the motors of an island of colliders, so each link has one.
    AddCollider(0, palm_shape_);
    for (const int link : {1, 2}) AddCollider(link, finger_shape_);
    AddMotors(dt);
  }
  ~RobotGripper() {
    for (const auto& motor : motors_) world_.removeMultiBodyConstraint(motor.get());
    for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    world_.removeMultiBody(&body_);
  }
  RobotGripper(const RobotGripper&) = delete;
  RobotGripper& operator=(const RobotGripper&) = delete;

  void SetLiftSpeed(double speed) { motors_[0]->setVelocityTarget(btScalar(speed), 1); }
  void Close(double speed) {
    for (const std::size_t finger : {1U, 2U}) motors_[finger]->setVelocityTarget(btScalar(speed), 1);
  }
  double Lift() const { return double(body_.getJointPos(0)); }
  /// Between the fingers' faces, m; negative if they have passed through each other.
  double Gap() const { return 2 * opening_ - double(body_.getJointPos(1)) - double(body_.getJointPos(2)); }

 private:
  void AddCollider(int link, btBoxShape& shape) {
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(&body_, link));
    btMultiBodyLinkCollider& collider = *colliders_.back();
    collider.setCollisionShape(&shape);
    collider.setFriction(1);
    world_.addCollisionObject(&collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
    body_.getLink(link).m_collider = &collider;
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> positions;
    body_.updateCollisionObjectWorldTransforms(rotations, positions);
  }
  void AddMotors(double dt) {
    constexpr double kLiftForce = 1000;  // N
    for (const int link : {0, 1, 2}) {
      const double impulse = (link == 0 ? kLiftForce : kGripForce) * dt;
      motors_.push_back(std::make_unique<btMultiBodyJointMotor>(&body_, link, btScalar(0), btScalar(impulse)));
      world_.addMultiBodyConstraint(motors_.back().get());
    }
  }

  btMultiBodyDynamicsWorld& world_;
  double opening_;  // Between each finger's face and the middle at first, m.
  btMultiBody body_;
  btBoxShape palm_shape_, finger_shape_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBodyJointMotor>> motors_;
};

struct Grip {
  Form part;
  double size;   // m
  double aside;  // Of the part from the middle of the fingers, m.
  int index;
};

/// What a dropped part counts, so that to drop it is no way to a better figure, mm.
constexpr double kSlipOfDropped = 10;

/// Whether the part is dropped, and how far it slips while it is held. A part that the fingers have closed through by
/// more than half is as good as dropped.
Case RunGrip(const Conditions& conditions, const Grip& it) {
  constexpr double kCloseTime = 0.3, kLiftTime = 0.4, kHoldTime = 0.8, kSpeed = 0.25;  // s, m/s
  Lab shapes(conditions);                                                              // Owns them.
  RobotWorld robot(conditions.narrowphase);
  const double dt = shapes.dt(), density = 1000;
  const auto run = [&](double seconds) {
    for (int step = shapes.StepsIn(seconds); step > 0; --step) robot.world.stepSimulation(btScalar(dt), 0);
  };
  btConvexShape& shape = shapes.MakeForm(it.part, it.size / 2);
  btBoxShape table_shape(Vec(0.5, 0.5, 0.05));
  const auto table = dgd_test::MakeRigidBody(table_shape, 0, At(Vec(0, 0, -0.05)));
  const double foot = FootOf(shape);
  const btTransform start = At(Vec(it.aside, 0.001, foot), Yaw(0.2 * (it.index % 4)));
  const auto part = dgd_test::MakeRigidBody(shape, density * it.size * it.size * it.size, start);
  part->setActivationState(DISABLE_DEACTIVATION);
  robot.world.addRigidBody(table.get());
  robot.world.addRigidBody(part.get());
  const double height = std::max(foot, 0.0225);  // The fingers clear the table.
  double dropped = 0, slip = 0;
  {
    RobotGripper gripper(robot, height, 0.7 * it.size + 0.005, dt);
    run(0.1);
    gripper.Close(0.1);
    run(kCloseTime);
    gripper.SetLiftSpeed(kSpeed);
    run(kLiftTime);
    gripper.SetLiftSpeed(0);
    run(0.1);
    const double held = HeightOf(*part) - gripper.Lift();
    run(kHoldTime);
    const bool is_held = HeightOf(*part) > 0.7 * kSpeed * kLiftTime && gripper.Gap() > it.size / 2;
    dropped = is_held ? 0 : 1;
    slip = std::abs(HeightOf(*part) - gripper.Lift() - held);
  }
  robot.world.removeRigidBody(part.get());
  robot.world.removeRigidBody(table.get());
  return {NameOf(it.part),
          NameOf(it.part) + " of " + Text(100 * it.size) + " cm, off by " + Text(1000 * it.aside) + " mm",
          {dropped, dropped > 0 ? kSlipOfDropped : 1000 * slip}};
}

std::vector<Grip> Grips() {
  std::vector<Grip> grips;
  for (const Form part : {Form::kBox, Form::kHull, Form::kCylinder, Form::kSphere, Form::kCapsule}) {
    for (const double size : {0.01, 0.02, 0.03, 0.04}) {
      for (const double aside : {0.002, -0.004}) grips.push_back({part, size, aside, int(grips.size())});
    }
  }
  return grips;
}

Cases RunGripper(const Conditions& conditions) { return RunCases(conditions, Grips(), 1, RunGrip); }

}  // namespace

App Gripper() {
  return {"gripper",
          "a gripper of a multibody picks parts of 1 to 4 cm off the table and holds them",
          {{"dropped parts", Combine::kTotal, 0, 1, "one of eight that the fingers just hold is chance"},
           {"slip in 0.8 s, mm", Combine::kMean, 0.1, 1.25, "one more of eight is dropped, which counts 10 mm"}},
          RunGripper};
}

}  // namespace dgd_apps
