// Paths by the sampling planners of OMPL.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/arm.h"
#include "motion/joint_path.h"

namespace dgd_demos {

enum class PlannerKind { kRrt, kRrtConnect };

struct PlanningProblem {
  Configuration lower, upper;  ///< Box that the search keeps to, rad.
  Configuration start, goal;   ///< In the box.
  std::function<bool(const Configuration&)> is_valid;
};

struct FoundPath {
  JointPath path;     ///< From the start.
  bool reaches_goal;  ///< If not, it ends where the tree came nearest to the goal.
};

/// Same problem and seed: same path, as long as no time limit ends the search. OMPL seeds its generators from a global
/// one that is set once for a process, so each of them is seeded here.
class SamplingPlanner {
 public:
  /// Share of the state space's extent, the diagonal of the problem's box, from one checked state of a motion
  /// to the next.
  static constexpr double kResolution = 0.001;
  /// @param problem  Start and goal must be valid. is_valid is called by the members below only.
  SamplingPlanner(PlannerKind kind, const PlanningProblem& problem, std::uint64_t seed);
  ~SamplingPlanner();

  /// Distance of two states of a motion that are checked, rad.
  double StepLength() const;

  /// Searches until there is a path or time is up. Each call starts from scratch, and finds another path.
  /// @param time_limit  s
  /// @return nothing if time is up before there is any tree.
  std::optional<FoundPath> FindPath(double time_limit);

  /// Removes what a path does not need: shortcuts between random points of it, as long as they help.
  JointPath Simplify(const JointPath& path);

 private:
  struct Ompl;  // Keeps OMPL out of this header.
  std::unique_ptr<Ompl> ompl_;
};

}  // namespace dgd_demos
