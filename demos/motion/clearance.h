// How far an arm stays from what it may hit along a path, and certificates that it hits nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include "motion/collision_model.h"
#include "motion/joint_path.h"
#include "motion/plane_cache.h"

namespace dgd_demos {

/// The least of one kind of distance along a path.
struct LeastDistance {
  double value = std::numeric_limits<double>::infinity();
  std::size_t pair = 0;  ///< Index in CollisionModel::pairs().
  double place = 0;      ///< Along the path, rad from its start.
  Configuration state;   ///< At that place.
};

struct Clearance {
  LeastDistance growth_distance;  ///< Dimensionless; above 1: apart.
  LeastDistance signed_distance;  ///< m; negative for penetration.
};

/// Called with the share of the work that is done, from 0 to 1.
using Progress = std::function<void(double)>;

/// The least growth distance and the least signed distance over all pairs in states at most `step` apart.
/// @param step  rad
Clearance MeasureClearance(const CollisionModel& model, const JointPath& path, double step,
                           const Progress& progress = {});

/// The least signed distance alone, m. A tenth of the time, as a plane of the cache keeps most pairs farther apart.
/// @param planes  In and out; of an earlier call for a similar path, or new.
double LeastSignedDistance(const CollisionModel& model, const JointPath& path, double step, PlaneCache& planes);

/// A state that is not proven to be free of collisions, and the pair for which the proof fails.
struct UnprovenState {
  std::size_t pair;
  double place;  ///< Along the path, rad from its start.
  Configuration state;
};

/// Looks for a pair and a state whose growth distance has no certificate (dgd/certificate.h) of being above 1. Shares
/// no code with the collision checks of planning: the growth distance is solved for, without a cached plane, and what
/// it claims is checked by the sets' support functions and by the distances of its witness points from the sets.
/// @param step  Between two states at most, rad.
std::optional<UnprovenState> FindUnprovenState(const CollisionModel& model, const JointPath& path, double step,
                                               const Progress& progress = {});

}  // namespace dgd_demos
