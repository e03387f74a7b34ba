#include "simulation/arm_world.h"

#include <algorithm>
#include <limits>
#include <map>

#include "motion/checked_pairs.h"
#include "simulation/bullet_math.h"
#include "simulation/bullet_shape.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Shapes as planning sees them, without a margin around hulls.
constexpr double kMargin = 0;

// The ball whose inertia a link gets that has neither inertia nor shapes: without any, its joint would not resist at
// all and Bullet's forward dynamics divide by zero. m
constexpr double kBallRadius = 0.05;

// Which bodies collide, by their user indices: links first, then fixed bodies.
std::vector<std::vector<bool>> CheckedPairs(const MotionScene& scene) {
  const SceneArm& arm = scene.arms[scene.planned_arm];
  const std::vector<FixedBody> fixed_bodies = FixedBodiesOf(scene);
  const std::size_t links = arm.arm.links.size(), bodies = links + fixed_bodies.size();
  std::vector checked(bodies, std::vector<bool>(bodies, false));
  for (std::size_t i = 0; i < links; ++i) {
    for (std::size_t j = i + 1; j < bodies; ++j) {
      checked[i][j] = checked[j][i] =
          j < links ? AreLinksChecked(arm, i, j) : IsCheckedAgainst(arm, i, fixed_bodies[j - links].name);
    }
  }
  return checked;
}

int IndexOf(const btBroadphaseProxy& proxy) {
  return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getUserIndex();
}

}  // namespace

bool CheckedPairFilter::needBroadphaseCollision(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1) const {
  return checked_[static_cast<std::size_t>(IndexOf(*proxy0))][static_cast<std::size_t>(IndexOf(*proxy1))];
}

ArmWorld::ArmWorld(const MotionScene& scene, const Configuration& start, const ExecutionOptions& options)
    : arm_(scene.PlannedArm()),
      time_step_(1 / options.step_rate),
      configuration_(MakeCollisionConfiguration(Narrowphase::kDgd)),
      dispatcher_(configuration_.get()),
      filter_(CheckedPairs(scene)),
      world_(&dispatcher_, &broadphase_, &solver_, configuration_.get()),
      body_(static_cast<int>(arm_.joints.size()), /*mass=*/0, btVector3(0, 0, 0), /*fixedBase=*/true,
            /*canSleep=*/false) {
  world_.setGravity(ToBullet(scene.gravity));
  world_.getSolverInfo().m_numIterations = options.solver_iterations;
  world_.getPairCache()->setOverlapFilterCallback(&filter_);
  AddArm(start);
  AddMotors(options.position_gain);
  AddFixedBodies(scene);
}

ArmWorld::~ArmWorld() {
  for (const auto& motor : motors_) world_.removeMultiBodyConstraint(motor.get());
  for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
  world_.removeMultiBody(&body_);
  for (const auto& fixed : fixed_bodies_) world_.removeRigidBody(fixed.get());
}

// A multibody's link has its frame in the centre of mass, with the axes of ours; the base, which is fixed, has its own.
Vector3d ArmWorld::CentreOf(std::size_t link) const {
  return link == 0 ? Vector3d::Zero() : arm_.links[link].centre_of_mass;
}

btCompoundShape& ArmWorld::MakeCompound(const std::vector<LinkShape>& shapes, const Vector3d& centre) {
  compounds_.push_back(std::make_unique<btCompoundShape>());
  for (const LinkShape& shape : shapes) {
    shapes_.push_back(MakeBulletShape(shape.shape, kMargin));
    const Pose pose = {shape.pose.rotation, shape.pose.position - centre};
    compounds_.back()->addChildShape(ToBullet(pose), shapes_.back().get());
  }
  return *compounds_.back();
}

// Estimated, where the scene has none, as that of a solid box about the link's shapes.
btVector3 ArmWorld::InertiaOf(const Link& link, const btCompoundShape& shape) const {
  if (link.inertia) return ToBullet(*link.inertia);
  if (link.shapes.empty()) return ToBullet(Vector3d::Constant(0.4 * link.mass * kBallRadius * kBallRadius));
  btVector3 inertia;
  shape.calculateLocalInertia(ToBullet(link.mass), inertia);
  return inertia;
}

void ArmWorld::AddArm(const Configuration& start) {
  for (std::size_t i = 0; i < arm_.links.size(); ++i) {
    names_.push_back(arm_.links[i].name);
    MakeCompound(arm_.links[i].shapes, CentreOf(i));
  }
  // Which links collide is the filter's to say.
  for (std::size_t i = 0; i < arm_.joints.size(); ++i) {
    const Joint& joint = arm_.joints[i];
    const Link& link = arm_.links[i + 1];
    const btQuaternion parent_to_link = ToBullet(joint.origin).getRotation().inverse();
    body_.setupRevolute(static_cast<int>(i), ToBullet(link.mass), InertiaOf(link, *compounds_[i + 1]),
                        static_cast<int>(i) - 1, parent_to_link, ToBullet(joint.axis),
                        ToBullet(joint.origin.position - CentreOf(i)), ToBullet(CentreOf(i + 1)),
                        /*disableParentCollision=*/false);
  }
  body_.finalizeMultiDof();
  // Nothing but gravity, motors and contacts acts on the arm.
  body_.setLinearDamping(0);
  body_.setAngularDamping(0);
  body_.setBaseWorldTransform(ToBullet(arm_.base));
  for (std::size_t i = 0; i < arm_.joints.size(); ++i) {
    body_.setJointPos(static_cast<int>(i), ToBullet(start[static_cast<Eigen::Index>(i)]));
  }
  world_.addMultiBody(&body_);

  // A link without shapes has a collider, too: Bullet finds the motors to be solved by the colliders of their links.
  for (std::size_t i = 0; i < arm_.links.size(); ++i) {
    const int link = static_cast<int>(i) - 1;
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(&body_, link));
    colliders_.back()->setCollisionShape(compounds_[i].get());
    colliders_.back()->setUserIndex(static_cast<int>(i));
    if (link < 0) {
      body_.setBaseCollider(colliders_.back().get());
    } else {
      body_.getLink(link).m_collider = colliders_.back().get();
    }
  }
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> places;
  body_.forwardKinematics(rotations, places);
  body_.updateCollisionObjectWorldTransforms(rotations, places);
  for (const auto& collider : colliders_) {
    world_.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
}

void ArmWorld::AddMotors(double position_gain) {
  for (std::size_t i = 0; i < arm_.joints.size(); ++i) {
    const btScalar max_impulse = ToBullet(arm_.joints[i].max_effort * time_step_);
    motors_.push_back(std::make_unique<btMultiBodyJointMotor>(&body_, static_cast<int>(i), btScalar(0), max_impulse));
    motors_.back()->setErp(ToBullet(position_gain));
    // An arm that was held up does not catch up faster than its joints may turn.
    motors_.back()->setRhsClamp(ToBullet(arm_.joints[i].max_velocity));
    world_.addMultiBodyConstraint(motors_.back().get());
  }
}

void ArmWorld::AddFixedBodies(const MotionScene& scene) {
  for (const FixedBody& fixed : FixedBodiesOf(scene)) {
    btCompoundShape& shape = MakeCompound(fixed.shapes, Vector3d::Zero());
    fixed_bodies_.push_back(std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(/*mass=*/0, nullptr, &shape, btVector3(0, 0, 0))));
    fixed_bodies_.back()->setWorldTransform(ToBullet(fixed.pose));
    fixed_bodies_.back()->setUserIndex(static_cast<int>(names_.size()));
    names_.push_back(fixed.name);
    world_.addRigidBody(fixed_bodies_.back().get());
  }
}

void ArmWorld::Step(const Configuration& now, const Configuration& next) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    motors_[i]->setPositionTarget(ToBullet(now[joint]));
    // The mean over the step, which is what Bullet integrates: the speed at either end would leave an error.
    motors_[i]->setVelocityTarget(ToBullet((next[joint] - now[joint]) / time_step_));
  }
  // No substeps: exactly one step of this length.
  world_.stepSimulation(ToBullet(time_step_), 0);
}

Configuration ArmWorld::JointAngles() const {
  Configuration angles(static_cast<Eigen::Index>(arm_.joints.size()));
  for (int i = 0; i < body_.getNumLinks(); ++i) angles[i] = body_.getJointPos(i);
  return angles;
}

Eigen::VectorXd ArmWorld::JointVelocities() const {
  Eigen::VectorXd velocities(static_cast<Eigen::Index>(arm_.joints.size()));
  for (int i = 0; i < body_.getNumLinks(); ++i) velocities[i] = body_.getJointVel(i);
  return velocities;
}

Eigen::VectorXd ArmWorld::MotorEfforts() const {
  Eigen::VectorXd efforts(static_cast<Eigen::Index>(motors_.size()));
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    efforts[static_cast<Eigen::Index>(i)] = motors_[i]->getAppliedImpulse(0) / time_step_;
  }
  return efforts;
}

std::vector<Pose> ArmWorld::LinkPosesNow() const {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < colliders_.size(); ++i) {
    const Pose pose = FromBullet(colliders_[i]->getWorldTransform());
    poses.push_back({pose.rotation, pose * -CentreOf(i)});
  }
  return poses;
}

Pose ArmWorld::FlangePoseNow() const { return LinkPosesNow().back() * arm_.flange; }

std::vector<ArmWorld::Contact> ArmWorld::Contacts() const {
  std::map<std::pair<int, int>, Contact> pairs;
  for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(m);
    const auto [first, second] =
        std::minmax({manifold.getBody0()->getUserIndex(), manifold.getBody1()->getUserIndex()});
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      const btManifoldPoint& point = manifold.getContactPoint(c);
      const double distance = point.getDistance(), force = point.getAppliedImpulse() / time_step_;
      // A manifold also has points of bodies that are close, or will only meet within the step if no motor brakes them:
      // these are shown as up to 0.1 mm deep.
      constexpr double kDeep = -1e-4;
      if (!(distance < kDeep || force > 0)) continue;
      Contact& contact =
          pairs.try_emplace({first, second}, Contact{first, second, std::numeric_limits<double>::infinity(), 0})
              .first->second;
      contact.distance = std::min(contact.distance, distance);
      contact.force += force;
    }
  }
  std::vector<Contact> contacts;
  for (const auto& [pair, contact] : pairs) contacts.push_back(contact);
  return contacts;
}

}  // namespace dgd_demos
