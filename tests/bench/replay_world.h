// A world without dynamics, whose bodies are put where a recording says, and whose dispatcher times every pair.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "scene/bodies.h"
#include "scene/pose.h"
#include "simulation/collision_input.h"
#include "simulation/narrowphase.h"

namespace dgd_bench {

/// What one narrowphase did about one pair of overlapping bounding boxes in one step.
struct PairSample {
  dgd_demos::BodyPair pair;
  double microseconds;    ///< Of the whole near callback, less what reading the clock takes.
  int contacts = 0;       ///< In the pair's manifold.
  double separation = 0;  ///< Of the deepest contact point, m; 0 without any.
};

/// Bullet's dispatcher with a stop watch around each pair.
class PairTimingDispatcher : public btCollisionDispatcher {
 public:
  explicit PairTimingDispatcher(btCollisionConfiguration* configuration);

  std::vector<PairSample> samples;  ///< Appended to by each dispatch.

 private:
  static void TimePair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

  double clock_us_;  // Of reading the clock twice.
};

/// Of its own bodies and shapes, made from a scene's.
class ReplayWorld {
 public:
  /// @param time_step  Of the recording, s.
  ReplayWorld(const std::vector<dgd_demos::Body>& bodies, dgd_demos::Narrowphase narrowphase, double time_step);
  ReplayWorld(const ReplayWorld&) = delete;
  ReplayWorld& operator=(const ReplayWorld&) = delete;

  /// Detects collisions once with all bodies at their poses, moving towards the next ones, and returns what was done.
  std::vector<PairSample> Detect(const std::vector<dgd_demos::Pose>& poses, const std::vector<dgd_demos::Pose>& next);

 private:
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  PairTimingDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> rigid_bodies_;
  btCollisionWorld world_;
  btScalar time_step_;
};

}  // namespace dgd_bench
