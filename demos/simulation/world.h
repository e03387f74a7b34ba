// A Bullet world made from a scene: one object that owns everything and takes fixed steps.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/bodies.h"
#include "scene/pose.h"
#include "scene/scene.h"
#include "simulation/collision_input.h"
#include "simulation/narrowphase.h"
#include "simulation/simulated_world.h"
#include "simulation/step_record.h"
#include "simulation/timing_dispatcher.h"

namespace dgd_demos {

class World : public SimulatedWorld {
 public:
  /// @param bodies  from MakeBodies(); the ground first.
  World(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase);

  void ShowQueriesTo(dgd_bullet::PairObserver& observer) override { dispatcher_.ShowQueriesTo(observer); }
  double time_step() const override { return time_step_; }
  CollisionReport Step() override;

  const std::vector<SimulatedBody>& Bodies() const override { return bodies_; }
  std::vector<OracleBody> OracleBodies() const override { return oracle_bodies_; }
  std::vector<Pose> Poses() const override;
  std::vector<BodyPair> OverlappingPairs() const override;
  std::vector<Motion> Motions() const override;
  Energy TotalEnergy() const override;
  Eigen::AlignedBox3d Room() const override { return room_; }
  btDynamicsWorld& Bullet() override { return world_; }

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

  std::vector<SimulatedBody> bodies_;
  std::vector<OracleBody> oracle_bodies_;
  bool may_sleep_;
  Eigen::Vector3d gravity_;
  Eigen::AlignedBox3d room_;
  double time_step_;
};

}  // namespace dgd_demos
