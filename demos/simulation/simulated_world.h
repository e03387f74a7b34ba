// A simulated world, from a scene or from a file of Bullet's. A run needs no more of it than this.
#pragma once

#include <dgd_bullet/options.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "scene/pose.h"
#include "scene/scene.h"
#include "simulation/collision_input.h"
#include "simulation/penetration_oracle.h"
#include "simulation/simulated_body.h"
#include "simulation/step_record.h"

class btDynamicsWorld;

namespace dgd_demos {

class SimulatedWorld {
 public:
  SimulatedWorld() = default;
  SimulatedWorld(const SimulatedWorld&) = delete;
  SimulatedWorld& operator=(const SimulatedWorld&) = delete;
  virtual ~SimulatedWorld() = default;

  /// Shows an observer, which must outlive this, the queries of the narrowphase from the next step on.
  virtual void ShowQueriesTo(dgd_bullet::PairObserver& observer) = 0;

  virtual double time_step() const = 0;  ///< s
  /// Advances by the time step.
  virtual CollisionReport Step() = 0;

  /// All bodies, in the order of poses, motions and the oracle's bodies.
  virtual const std::vector<SimulatedBody>& Bodies() const = 0;
  /// What the oracle judges them by.
  virtual std::vector<OracleBody> OracleBodies() const = 0;

  virtual std::vector<Pose> Poses() const = 0;  ///< Now.
  /// Pairs of overlapping bounding boxes in the last step. Poses taken before a step and pairs after it are what its
  /// narrowphase was given.
  virtual std::vector<BodyPair> OverlappingPairs() const = 0;
  virtual std::vector<Motion> Motions() const = 0;
  virtual Energy TotalEnergy() const = 0;

  /// Box in which the centres of moving bodies are expected, world frame, m.
  virtual Eigen::AlignedBox3d Room() const = 0;
  /// A sentence about the first moving body that has left the room, or has a pose or a velocity that is not finite.
  /// @param motions  from Motions().
  std::optional<std::string> FindLostBody(const std::vector<Motion>& motions) const;

  /// The world itself, with all of Bullet's objects; their user indices are the bodies'.
  virtual btDynamicsWorld& Bullet() = 0;
};

/// Speeds of the centres of mass, m/s.
std::vector<double> SpeedsOf(const std::vector<Motion>& motions);

}  // namespace dgd_demos
