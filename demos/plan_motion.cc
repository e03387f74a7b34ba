// plan_motion: the motion of an arm between obstacles, planned, proven free, and smoothed. See --help.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "motion/check_comparison.h"
#include "motion/collision_model.h"
#include "motion/motion_scene.h"
#include "motion/path_picture.h"
#include "motion/plan_report.h"
#include "motion/plan_run.h"
#include "motion/timed_path.h"
#include "plan_motion_options.h"
#include "program_main.h"
#include "render/png_file.h"
#include "report/csv_file.h"
#include "report/execution_csv.h"
#include "report/progress_bar.h"
#include "simulation/execution.h"

namespace dgd_demos {
namespace {

// The first so many states of each run: as many as an hour's comparison does not need.
constexpr std::size_t kMostComparedStates = 20'000;

// From where all that is behind something in one picture is before it in the other, rad.
constexpr double kOtherSide = 1.5;

// One bar for each kind of work, which wipes that of the work before.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(std::uint64_t seed) : prefix_("seed " + std::to_string(seed) + ", ") {}
  void Update(std::string_view work, double share) {
    if (work != work_) {
      work_ = work;
      bar_.emplace(prefix_ + work_, 1);
    }
    bar_->Update(share);
  }

 private:
  std::string prefix_, work_;
  std::optional<ProgressBar> bar_;
};

template <class... Values>
std::string Sentence(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

void WritePaths(const PlanRun& run, const CollisionModel& model, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  // Whatever an earlier run has left is not of this one.
  for (const char* name : {"path_found.csv", "path_simplified.csv", "path_smoothed.csv", "path.png",
                           "path_other_side.png", "execution.csv", "execution.png"}) {
    std::filesystem::remove(folder / name);
  }
  if (!run.found.empty()) WritePathCsv(folder / "path_found.csv", model, run.found);
  if (run.failure) return;
  WritePathCsv(folder / "path_simplified.csv", model, run.simplified);
  WritePathCsv(folder / "path_smoothed.csv", model, run.smoothed);
}

void WritePictures(const PlanRun& run, const CollisionModel& model, const std::filesystem::path& folder) {
  char subtitle[160];
  std::snprintf(subtitle, sizeof subtitle, "seed %llu,  %.2f rad,  clearance %.1f mm, before smoothing %.1f mm",
                static_cast<unsigned long long>(run.seed), Length(run.smoothed), 1e3 * run.after.signed_distance.value,
                1e3 * run.before.signed_distance.value);
  const std::string title = "Motion of " + model.arm().name;
  WritePng(folder / "path.png", Draw({model, run.smoothed, run.simplified, title, subtitle}));
  WritePng(folder / "path_other_side.png", Draw({model, run.smoothed, run.simplified, title, subtitle, kOtherSide}));
}

void WriteComparison(const std::vector<CheckTimes>& times, const std::filesystem::path& file) {
  CsvFile csv(file);
  csv.stream() << "checker,seconds,pairs,differing,beyond_band\n";
  for (const CheckTimes& row : times) {
    csv.stream() << '"' << row.name << "\"," << row.seconds << ',' << row.pairs << ',' << row.differing << ','
                 << row.beyond_band << '\n';
  }
  csv.Flush();
}

// Why an execution is none of the path, in a sentence; nothing if it is.
std::optional<std::string> FindExecutionFailure(const Arm& arm, const PlanRun& run) {
  constexpr double kMostError = 0.01;    // Of the flange, m.
  constexpr double kBeyondLimit = 1e-3;  // rad
  const ExecutionResult& execution = *run.execution;
  const auto seed = static_cast<unsigned long long>(run.seed);
  if (!execution.contacts.empty()) {
    const ExecutionContact& contact = execution.contacts.front();
    return Sentence("seed %llu: in the execution, %s and %s touch after %.2f s", seed, contact.first.c_str(),
                    contact.second.c_str(), contact.begin);
  }
  if (!(execution.greatest_error <= kMostError)) {
    return Sentence(
        "seed %llu: in the execution, the flange is %.4g m off its path after %.2f s; the joint %s takes %.0f %% of "
        "its effort",
        seed, execution.greatest_error, execution.greatest_error_time, execution.greatest_effort_joint.c_str(),
        100 * execution.greatest_effort_share);
  }
  for (const ExecutionStep& step : execution.steps) {
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      const Joint& joint = arm.joints[i];
      const double angle = step.angles[static_cast<Eigen::Index>(i)];
      if (angle >= joint.lower - kBeyondLimit && angle <= joint.upper + kBeyondLimit) continue;
      return Sentence("seed %llu: in the execution, the joint %s is at %.4g rad after %.2f s, beyond its limits", seed,
                      joint.name.c_str(), angle, step.time);
    }
  }
  return std::nullopt;
}

// Carries out the smoothed path in a world on the plugin.
void Execute(const MotionScene& scene, const CollisionModel& model, ProgressDisplay& display, PlanRun& run) {
  // Corners are cut by as much of the clearance as leaves half of it, for points at most a metre from the axes.
  TimingOptions timing;
  const double joints = static_cast<double>(model.arm().joints.size());
  timing.max_deviation = std::min(timing.max_deviation, run.after.signed_distance.value / (2 * std::sqrt(joints)));
  const TimedPath path(model.arm(), run.smoothed, timing);
  constexpr double kLongest = 600;  // s
  if (path.Duration() > kLongest) {
    run.failure =
        Sentence("seed %llu: the path takes %.4g s at the joints' velocity limits; more than %g s are not simulated",
                 static_cast<unsigned long long>(run.seed), path.Duration(), kLongest);
    return;
  }
  run.execution = ExecutePath(scene, path, {}, [&](double share) { display.Update("execution", share); });
  if (!run.execution->failure) run.execution->failure = FindExecutionFailure(model.arm(), run);
}

void WriteExecution(const PlanRun& run, const CollisionModel& model, bool draws, const std::filesystem::path& folder) {
  const std::vector<ExecutionStep>& steps = run.execution->steps;
  WriteExecutionCsv(folder / "execution.csv", model.arm(), steps);
  if (!draws || steps.empty()) return;
  // As many as a trace needs, from the first to the last: each piece of it is a body to draw.
  constexpr std::size_t kMostStates = 100;
  const std::size_t last = steps.size() - 1, parts = std::min(last, kMostStates);
  JointPath states = {steps.front().angles};
  std::vector<double> times = {steps.front().time};
  for (std::size_t i = 1; i <= parts; ++i) {
    const ExecutionStep& step = steps[last * i / parts];
    states.push_back(step.angles);
    times.push_back(step.time);
  }
  WritePng(folder / "execution.png", DrawContactSheet({model, run.smoothed, times, states, kOtherSide}));
}

PlanRun PlanAndWrite(const MotionScene& scene, const CollisionModel& model, const PlanMotionOptions& options,
                     std::uint64_t seed, RunsCsv& csv) {
  ProgressDisplay display(seed);
  PlanRun run = PlanMotion(scene, model, {options.planner, options.time_limit, seed, options.compares},
                           [&](std::string_view work, double share) { display.Update(work, share); });
  const std::filesystem::path folder =
      options.seeds == 1 ? options.out : options.out / ("seed_" + std::to_string(seed));
  WritePaths(run, model, folder);
  const bool has_plan = !run.failure;
  if (has_plan) Execute(scene, model, display, run);
  csv.Write(run);
  if (!has_plan) return run;
  if (options.draws) {
    display.Update("pictures", 0);
    WritePictures(run, model, folder);
  }
  if (run.execution) WriteExecution(run, model, options.draws, folder);
  return run;
}

ExitStatus Run(const PlanMotionOptions& options) {
  const MotionScene scene = LoadMotionScene(options.scene);
  const CollisionModel model(scene);
  if (const std::optional<std::string> collision = FindCollisionAtEnds(scene, model)) {
    std::fprintf(stderr, "%s: %s\n", scene.file.c_str(), collision->c_str());
    return kNoPath;
  }
  std::filesystem::create_directories(options.out);
  RunsCsv csv(options.out / "runs.csv");
  std::vector<PlanRun> runs;
  std::vector<Configuration> visited;
  for (int i = 0; i < options.seeds; ++i) {
    runs.push_back(PlanAndWrite(scene, model, options, options.seed + static_cast<std::uint64_t>(i), csv));
    std::vector<Configuration>& states = runs.back().visited;
    if (states.size() > kMostComparedStates) states.resize(kMostComparedStates);
    visited.insert(visited.end(), states.begin(), states.end());
    states = {};
  }

  std::printf("%s: the arm %s, %zu pairs of bodies\n\n%s", scene.file.c_str(), model.arm().name.c_str(),
              model.pairs().size(), FormatRuns(runs).c_str());
  if (runs.size() == 1 && !runs[0].failure) std::printf("\n%s", FormatPlaces(model, runs[0]).c_str());
  for (const PlanRun& run : runs) {
    if (run.execution) std::printf("%s", FormatContacts(*run.execution).c_str());
  }
  if (options.compares && !visited.empty()) {
    ProgressBar progress("comparison", 1);
    const std::vector<CheckTimes> times = CompareChecks(model, visited, [&](double share) { progress.Update(share); });
    WriteComparison(times, options.out / "comparison.csv");
    std::printf("\n%s", FormatComparison(times).c_str());
  }
  std::printf("\nResults are in %s\n", options.out.c_str());

  ExitStatus status = kSuccess;
  for (const PlanRun& run : runs) {
    const std::optional<std::string>& failure = run.execution ? run.execution->failure : run.failure;
    if (!failure) continue;
    std::fprintf(stderr, "%s\n", failure->c_str());
    status = kNoPath;
  }
  return status;
}

}  // namespace
}  // namespace dgd_demos

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_demos::ParseCommandLine(argc, argv), dgd_demos::Run);
}
