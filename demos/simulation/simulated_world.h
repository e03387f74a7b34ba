// A world that is simulated, wherever it comes from: a scene, or a file of Bullet's. A run needs no more of it than
// this.
#pragma once

#include <dgd_bullet/recorder.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scene/pose.h"
#include "scene/scene.h"
#include "simulation/collision_input.h"
#include "simulation/penetration_oracle.h"
#include "simulation/step_record.h"

class btDynamicsWorld;

namespace dgd_demos {

struct SimulatedBody {
  std::string name;       ///< For messages.
  bool moves;             ///< False: static.
  Eigen::Vector3d start;  ///< Of the local origin at the beginning, m.
  double radius;          ///< Of the ball about the local origin that contains it, m; infinite if there is none.
};

class SimulatedWorld {
 public:
  SimulatedWorld() = default;
  SimulatedWorld(const SimulatedWorld&) = delete;
  SimulatedWorld& operator=(const SimulatedWorld&) = delete;
  virtual ~SimulatedWorld() = default;

  /// From the next step on, the recorder gets what the narrowphase is asked. It must outlive this.
  virtual void RecordInto(dgd_bullet::Recorder& recorder) = 0;

  virtual double time_step() const = 0;  ///< s
  /// Advances by the time step.
  virtual CollisionReport Step() = 0;

  /// All bodies; their order is that of all that is said of each.
  virtual const std::vector<SimulatedBody>& Bodies() const = 0;
  /// What the oracle judges them by.
  virtual std::vector<OracleBody> OracleBodies() const = 0;

  virtual std::vector<Pose> Poses() const = 0;  ///< Now.
  /// Of overlapping bounding boxes in the last step. Poses taken before a step and pairs after it are what its
  /// narrowphase was given.
  virtual std::vector<BodyPair> OverlappingPairs() const = 0;
  virtual std::vector<Motion> Motions() const = 0;
  std::vector<double> Speeds() const;  ///< Of the centres of mass, m/s.
  virtual Energy TotalEnergy() const = 0;

  /// A sentence about the first body that has left the world or has a pose or a velocity that is not finite.
  virtual std::optional<std::string> FindLostBody() const = 0;

  /// The world itself, with all of Bullet's objects; their user indices are the bodies'.
  virtual btDynamicsWorld& Bullet() = 0;
};

inline std::vector<double> SimulatedWorld::Speeds() const {
  std::vector<double> speeds;
  for (const Motion& motion : Motions()) speeds.push_back(motion.velocity.norm());
  return speeds;
}

}  // namespace dgd_demos
