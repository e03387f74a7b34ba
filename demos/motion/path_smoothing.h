// Pushes a path away from what it nearly hits, by the gradients of the growth distance.
#pragma once

#include "motion/clearance.h"
#include "motion/collision_model.h"
#include "motion/joint_path.h"

namespace dgd_demos {

struct SmoothingOptions {
  double most_lengthening = 1.1;  ///< Length of the result by that of the path, at most.
  double waypoint_step = 0.1;     ///< Between the configurations that are moved, rad at most.
  double check_step = 0.01;       ///< Between the states at which the clearance is taken, rad at most.
};

/// A path from the same start to the same goal that keeps a larger least distance from obstacles, and of links from
/// each other, than the given one; the given one if none is found.
///
/// An elastic band: each configuration is pushed along the joint-space gradients of those pairs that are nearer than a
/// margin, and pulled towards the middle of its neighbours, which spreads the push and keeps the band short. The margin
/// grows until nothing is gained. Of all bands on the way, the one with the largest clearance that is not too long is
/// returned, so the result is never worse than the path. Method: Quinlan and Khatib, Elastic bands, ICRA 1993.
JointPath Smooth(const CollisionModel& model, const JointPath& path, const SmoothingOptions& options = {},
                 const Progress& progress = {});

}  // namespace dgd_demos
