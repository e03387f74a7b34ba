// The Bullet world of a motion scene: the planned arm as a multibody with a motor in each joint, all else fixed.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "motion/arm.h"
#include "motion/motion_scene.h"
#include "scene/pose.h"
#include "simulation/execution.h"

namespace dgd_demos {

/// Which bodies collide, by their user indices.
class CheckedPairFilter : public btOverlapFilterCallback {
 public:
  /// @param checked  Whether bodies i and j collide; both (i, j) and (j, i) are set.
  explicit CheckedPairFilter(std::vector<std::vector<bool>> checked) : checked_(std::move(checked)) {}
  bool needBroadphaseCollision(btBroadphaseProxy* proxy0, btBroadphaseProxy* proxy1) const override;

 private:
  std::vector<std::vector<bool>> checked_;
};

class ArmWorld {
 public:
  /// The arm is at rest in the configuration `start`.
  ArmWorld(const MotionScene& scene, const Configuration& start, const ExecutionOptions& options);
  ~ArmWorld();
  ArmWorld(const ArmWorld&) = delete;
  ArmWorld& operator=(const ArmWorld&) = delete;

  /// Advances by a step in which the motors drive the joints from `now` to `next`, as far as their effort allows.
  void Step(const Configuration& now, const Configuration& next);

  Configuration JointAngles() const;
  Eigen::VectorXd JointVelocities() const;  ///< rad/s
  Eigen::VectorXd MotorEfforts() const;     ///< Mean over the last step, N m.
  std::vector<Pose> LinkPosesNow() const;   ///< Bullet's poses in the world, base first.
  Pose FlangePoseNow() const;

  /// A pair in contact in the last step: it overlapped when the step began, or one body pushed the other.
  struct Contact {
    int first, second;  ///< User indices; see NameOf(). The first is the smaller one, so a link.
    double distance;    ///< m, when the step began.
    double force;       ///< Along the normals, N.
  };
  std::vector<Contact> Contacts() const;
  const std::string& NameOf(int index) const { return names_[static_cast<std::size_t>(index)]; }

 private:
  void AddArm(const Configuration& start);
  void AddMotors(double position_gain);
  void AddFixedBodies(const MotionScene& scene);
  btCompoundShape& MakeCompound(const std::vector<LinkShape>& shapes, const Eigen::Vector3d& centre);
  btVector3 InertiaOf(const Link& link, const btCompoundShape& shape) const;
  Eigen::Vector3d CentreOf(std::size_t link) const;

  const Arm arm_;
  const double time_step_;

  // Members in order of construction: each refers to those above it until it is destroyed.
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  btCollisionDispatcher dispatcher_;
  CheckedPairFilter filter_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btCompoundShape>> compounds_;
  std::vector<std::unique_ptr<btRigidBody>> fixed_bodies_;
  btMultiBody body_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;  // Colliders of the links, base first.
  std::vector<std::unique_ptr<btMultiBodyJointMotor>> motors_;
  std::vector<std::string> names_;  // Names by user index: links first, then fixed bodies.
};

}  // namespace dgd_demos
