#include "motion/plan_execution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "motion/timed_path.h"
#include "simulation/execution.h"

namespace dgd_demos {
namespace {

constexpr double kLongest = 600;       // Simulated at most, s.
constexpr double kMostError = 0.01;    // Of the flange, m.
constexpr double kBeyondLimit = 1e-3;  // What a joint that is driven to its limit may overshoot by, rad.

// Why the arm did not follow the path, in a sentence; nothing if it did.
std::optional<std::string> FindFailure(const Arm& arm, const ExecutionResult& execution) {
  if (execution.failure) return execution.failure;
  std::ostringstream text;
  if (!execution.contacts.empty()) {
    const ExecutionContact& contact = execution.contacts.front();
    text << contact.first << " and " << contact.second << " touch after " << contact.begin << " s";
    return text.str();
  }
  if (!(execution.greatest_error <= kMostError)) {  // Also for NaN.
    text << "the flange is " << execution.greatest_error << " m off its path after " << execution.greatest_error_time
         << " s; joint " << execution.greatest_effort_joint << " takes " << 100 * execution.greatest_effort_share
         << " % of its effort";
    return text.str();
  }
  for (const ExecutionStep& step : execution.steps) {
    const std::optional<std::size_t> joint = FindJointBeyondLimits(arm, step.angles, kBeyondLimit);
    if (!joint) continue;
    text << "joint " << arm.joints[*joint].name << " is beyond its limits after " << step.time << " s, with "
         << step.angles[static_cast<Eigen::Index>(*joint)] << " rad";
    return text.str();
  }
  return std::nullopt;
}

}  // namespace

void ExecutePlan(const MotionScene& scene, PlanRun& run, const Progress& progress) {
  const Arm& arm = scene.PlannedArm();
  const std::string prefix = "seed " + std::to_string(run.seed) + ": in the execution, ";
  TimingOptions timing;
  const double clearance_per_rad =
      run.after.signed_distance.value / (2 * std::sqrt(static_cast<double>(arm.joints.size())));
  timing.max_deviation = std::min(timing.max_deviation, clearance_per_rad);
  const TimedPath path(arm, run.smoothed, timing);
  if (path.Duration() > kLongest) {
    std::ostringstream text;
    text << prefix << "the path takes " << path.Duration() << " s at the joints' velocity limits; more than "
         << kLongest << " s are not simulated";
    run.execution_failure = text.str();
    return;
  }
  run.execution = ExecutePath(scene, path, {}, progress);
  if (const std::optional<std::string> failure = FindFailure(arm, *run.execution)) {
    run.execution_failure = prefix + *failure;
  }
}

}  // namespace dgd_demos
