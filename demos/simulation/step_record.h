// The state and the counts of one simulation step, free of Bullet.
#pragma once

#include <cstdint>
#include <optional>

namespace dgd_demos {

/// What the collision detection of one step did. It runs at the poses in which the step begins.
struct CollisionReport {
  double narrowphase_us;       ///< Wall time of the dispatch of all pairs.
  int pairs;                   ///< Pairs of overlapping bounding boxes.
  int queries;                 ///< Pairs of which a body is awake: those that the narrowphase processed.
  int contacts;                ///< Points in all contact manifolds, the slightly separated ones included.
  double deepest_penetration;  ///< Greatest depth that a contact point reports, m; 0 if none penetrates.
  std::uint64_t fallbacks;     ///< Queries that the plugin handed back to Bullet's GJK/EPA.
};

struct Energy {
  double kinetic;    ///< J, translation and rotation.
  double potential;  ///< J, 0 with the centre of mass on the ground's top.
};

struct StepRecord {
  double time;    ///< At the end of the step, s.
  Energy energy;  ///< At the end of the step.
  CollisionReport collision;
  /// Deepest true penetration at the poses that the narrowphase was given, m; nothing if the oracle was not run.
  std::optional<double> true_penetration;
  /// Pairs of overlapping bounding boxes that the oracle cannot judge, those with a mesh; 0 if it was not run.
  int unjudged_pairs = 0;
};

}  // namespace dgd_demos
