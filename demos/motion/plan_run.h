// One planned motion, from the search to the certified and smoothed path, and what it took.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/clearance.h"
#include "motion/collision_model.h"
#include "motion/motion_scene.h"
#include "motion/sampling_planner.h"
#include "motion/state_checker.h"
#include "simulation/execution.h"

namespace dgd_demos {

struct PlanSettings {
  PlannerKind planner = PlannerKind::kRrtConnect;
  double time_limit = 5;  ///< Of the search with all its attempts, s.
  std::uint64_t seed = 1;
  bool keeps_visited = false;  ///< Whether PlanRun::visited is filled.
};

struct PlanRun {
  std::uint64_t seed = 0;
  /// Why there is no plan, in a sentence; nothing if there is one.
  std::optional<std::string> failure;

  int attempts = 0;                   ///< Paths searched for: more than one if some failed the certified re-check.
  double search_time = 0;             ///< Search and simplification, all attempts, s.
  double recheck_time = 0;            ///< Certified re-checks of these, s.
  double smoothing_time = 0;          ///< With the re-check of what it gave, s.
  CheckCounts counts;                 ///< Of search and simplification.
  double check_time = 0;              ///< Of these checks, with the kinematics, s.
  std::int64_t rechecked_states = 0;  ///< Of the path that is returned; each pair has a certificate in each.

  JointPath found;                               ///< By the search; if that failed, as far as it came.
  JointPath simplified;                          ///< Certified, if there is a plan.
  JointPath smoothed;                            ///< Certified; the simplified one if smoothing gained nothing.
  Clearance before, after;                       ///< Of the simplified and the smoothed path.
  std::optional<ExecutionResult> execution;      ///< Of the smoothed path; see ExecutePlan().
  std::optional<std::string> execution_failure;  ///< Why the arm does not follow that, in a sentence.
  std::vector<Configuration> visited;            ///< States checked by search and simplification, in their order.
};

/// Called with what is being done, and the share of it that is done.
using PlanProgress = std::function<void(std::string_view, double)>;

/// Why no path can start or end where the scene wants it: the pair that collides there, in a sentence; or nothing.
std::optional<std::string> FindCollisionAtEnds(const MotionScene& scene, const CollisionModel& model);

/// @pre !FindCollisionAtEnds(scene, model).
PlanRun PlanMotion(const MotionScene& scene, const CollisionModel& model, const PlanSettings& settings,
                   const PlanProgress& progress = {});

}  // namespace dgd_demos
