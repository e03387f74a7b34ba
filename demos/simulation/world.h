// A Bullet world made from a scene: one object that owns everything and takes fixed steps.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/bodies.h"
#include "scene/pose.h"
#include "scene/scene.h"
#include "simulation/collision_input.h"
#include "simulation/narrowphase.h"
#include "simulation/step_record.h"
#include "simulation/timing_dispatcher.h"

namespace dgd_demos {

class World {
 public:
  /// @param bodies  from MakeBodies(); the ground first.
  World(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// From the next step on, the recorder gets what the narrowphase is asked. It must outlive this.
  void RecordInto(dgd_bullet::Recorder& recorder) { dispatcher_.RecordInto(recorder); }

  /// Advances by the scene's time step.
  CollisionReport Step();

  /// Poses of all bodies now, in the order of `bodies`; and the pairs of overlapping bounding boxes of the last step.
  /// Poses taken before a step and pairs after it are what its narrowphase was given.
  std::vector<Pose> Poses() const;
  std::vector<BodyPair> OverlappingPairs() const;

  std::vector<double> Speeds() const;  ///< Of the centres of mass, m/s.
  Energy TotalEnergy() const;

  /// A sentence about the first body that has left the world or has a pose or a velocity that is not finite.
  std::optional<std::string> FindLostBody() const;

 private:
  void AddBody(const Body& body, int index);

  // In order of construction: each needs those above it until it is gone.
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  TimingDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> rigid_bodies_;
  btDiscreteDynamicsWorld world_;

  std::vector<std::string> names_;
  bool may_sleep_;
  Eigen::Vector3d gravity_;
  Eigen::Vector3d room_min_, room_max_;  // Where a body's centre may be.
  double time_step_;
  std::uint64_t fallbacks_so_far_ = 0;
};

}  // namespace dgd_demos
