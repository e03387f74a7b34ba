#include "motion/plan_run.h"

#include <chrono>
#include <sstream>
#include <utility>

#include "motion/path_smoothing.h"

namespace dgd_demos {
namespace {

constexpr double kRecheckFiner = 10;  // Times the resolution of planning.

using Clock = std::chrono::steady_clock;

// Adds the time of its life.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

std::string Sentence(const PlanRun& run, const PlanSettings& settings, const std::string& why) {
  std::ostringstream text;
  text << "seed " << run.seed << ": no path from start to goal within " << settings.time_limit << " s, " << why
       << "; checked " << run.counts.states << " states";
  return text.str();
}

class Run {
 public:
  Run(const MotionScene& scene, const CollisionModel& model, const PlanSettings& settings, const PlanProgress& progress)
      : model_(model),
        settings_(settings),
        progress_(progress),
        checker_(model),
        goal_(scene.goal),
        planner_(settings.planner,
                 {scene.search_lower, scene.search_upper, scene.start, scene.goal,
                  [this](const Configuration& state) { return IsValid(state); }},
                 settings.seed),
        recheck_step_(planner_.StepLength() / kRecheckFiner) {
    run_.seed = settings.seed;
  }

  PlanRun Execute() {
    FindCertifiedPath();
    run_.counts = checker_.counts();
    if (run_.failure) {
      *run_.failure = Sentence(run_, settings_, *run_.failure);
      return std::move(run_);
    }
    SmoothPath();
    run_.rechecked_states = static_cast<std::int64_t>(Subdivide(run_.smoothed, recheck_step_).size());
    run_.before = MeasureClearance(model_, run_.simplified, recheck_step_, ProgressOf("clearance before"));
    run_.after = MeasureClearance(model_, run_.smoothed, recheck_step_, ProgressOf("clearance after"));
    return std::move(run_);
  }

 private:
  bool IsValid(const Configuration& state) {
    if (settings_.keeps_visited) run_.visited.push_back(state);
    const Stopwatch stopwatch(run_.check_time);
    return !checker_.FindCollision(state);
  }

  Progress ProgressOf(const char* work) const {
    if (!progress_) return {};
    return [this, work](double share) { progress_(work, share); };
  }

  // Searches, simplifies and re-checks, until a path passes or time is up.
  void FindCertifiedPath() {
    std::string why = "not even a first branch";
    double remaining = settings_.time_limit;
    while (remaining > 0) {
      ++run_.attempts;
      if (progress_) progress_("search", 0);
      std::optional<FoundPath> found;
      {
        const Stopwatch stopwatch(run_.search_time);
        found = planner_.FindPath(remaining);
        if (found) run_.found = found->path;
        if (found && found->reaches_goal) run_.simplified = planner_.Simplify(found->path);
      }
      if (found && !found->reaches_goal) {
        std::ostringstream text;
        text << "nearest branch ends " << (found->path.back() - goal_).norm() << " rad from the goal";
        why = text.str();
      }
      if (!found || !found->reaches_goal) break;
      if (IsCertified(run_.simplified, run_.recheck_time, why)) return;
      remaining = settings_.time_limit - run_.search_time - run_.recheck_time;
    }
    run_.simplified.clear();
    run_.failure = why;
  }

  bool IsCertified(const JointPath& path, double& time, std::string& why) {
    const Stopwatch stopwatch(time);
    const std::optional<UnprovenState> unproven =
        FindUnprovenState(model_, path, recheck_step_, ProgressOf("certified re-check"));
    if (!unproven) return true;
    why = "as " + model_.NameOf(model_.pairs()[unproven->pair]) + " met between checked states in the last one found";
    return false;
  }

  void SmoothPath() {
    {
      const Stopwatch stopwatch(run_.smoothing_time);
      run_.smoothed = Smooth(model_, run_.simplified, {}, ProgressOf("smoothing"));
    }
    std::string ignored;
    if (!IsCertified(run_.smoothed, run_.smoothing_time, ignored)) run_.smoothed = run_.simplified;
  }

  const CollisionModel& model_;
  const PlanSettings settings_;
  const PlanProgress& progress_;
  StateChecker checker_;
  PlanRun run_;
  Configuration goal_;
  SamplingPlanner planner_;
  const double recheck_step_;  // rad
};

}  // namespace

std::optional<std::string> FindCollisionAtEnds(const MotionScene& scene, const CollisionModel& model) {
  StateChecker checker(model);
  for (const auto& [name, state] : {std::pair("start", scene.start), std::pair("goal", scene.goal)}) {
    if (const std::optional<std::size_t> pair = checker.FindCollision(state)) {
      return "the " + std::string(name) + " is in collision: " + model.NameOf(model.pairs()[*pair]) + " overlap";
    }
  }
  return std::nullopt;
}

PlanRun PlanMotion(const MotionScene& scene, const CollisionModel& model, const PlanSettings& settings,
                   const PlanProgress& progress) {
  return Run(scene, model, settings, progress).Execute();
}

}  // namespace dgd_demos
