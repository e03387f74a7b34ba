// plan_motion: the motion of an arm between obstacles, planned, proven free, and smoothed. See --help.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "motion/check_comparison.h"
#include "motion/collision_model.h"
#include "motion/motion_scene.h"
#include "motion/path_picture.h"
#include "motion/plan_execution.h"
#include "motion/plan_report.h"
#include "motion/plan_run.h"
#include "plan_motion_options.h"
#include "program_main.h"
#include "render/off_screen.h"
#include "render/png_file.h"
#include "report/csv_file.h"
#include "report/execution_csv.h"
#include "report/output_folder.h"
#include "report/progress_bar.h"
#include "scene/world_hash.h"

namespace dgd_demos {
namespace {

// Of each run, the first so many: they bound the memory and the time of a search that goes on to its limit.
constexpr std::size_t kMostComparedStates = 20'000;

// Between the two views of a path, rad: what an obstacle hides in one is seen in the other.
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

constexpr const char* kPlanFiles[] = {"path_found.csv",      "path_simplified.csv", "path_smoothed.csv", "path.png",
                                      "path_other_side.png", "execution.csv",       "execution.png"};

Results ResultsOf(const PlanMotionOptions& options) {
  return {options.out,
          "plan.json",
          {{"scene", options.scene.filename().string() + " " + HashOfWorld(options.scene)},
           {"--planner", options.planner == PlannerKind::kRrt ? "rrt" : "rrt_connect"},
           {"--time-limit", options.time_limit},
           {"--seed", options.seed},
           {"--seeds", options.seeds}},
          [](const std::string& name) {
            return name == "runs.csv" || name == "comparison.csv" || std::ranges::count(kPlanFiles, name) > 0;
          }};
}

void WritePaths(const PlanRun& run, const CollisionModel& model, const std::filesystem::path& folder) {
  MakeOutputFolder(folder);
  // Whatever an earlier run has left is not of this one.
  for (const char* name : kPlanFiles) std::filesystem::remove(folder / name);
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
  csv << "checker,seconds,pairs,differing,beyond_band\n";
  for (const CheckTimes& row : times) {
    csv << '"' << row.name << "\"," << row.seconds << ',' << row.pairs << ',' << row.differing << ',' << row.beyond_band
        << '\n';
  }
  csv.Flush();
}

void WriteExecution(const PlanRun& run, const CollisionModel& model, bool draws, const std::filesystem::path& folder) {
  const std::vector<ExecutionStep>& steps = run.execution->steps;
  WriteExecutionCsv(folder / "execution.csv", model.arm(), steps);
  if (!draws || steps.empty()) return;
  // As many as a smooth trace needs, from the first to the last: each piece of it is a body to draw.
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
  if (!run.failure) ExecutePlan(scene, run, [&](double share) { display.Update("execution", share); });
  csv.Write(run);
  if (run.failure) return run;
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
  if (options.draws) LoadOsMesa();  // A program that cannot draw says so before it plans.
  if (const std::optional<std::string> collision = FindCollisionAtEnds(scene, model)) {
    std::fprintf(stderr, "%s: %s\n", scene.file.c_str(), collision->c_str());
    return kNoPath;
  }
  ClaimFolder(ResultsOf(options), options.overwrite);
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
    const std::optional<std::string>& failure = run.failure ? run.failure : run.execution_failure;
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
