// contact_report: many scenes in Bullet, on several narrowphases, their contacts judged side by side. See --help.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "contact_report_options.h"
#include "program_main.h"
#include "report/comparison_table.h"
#include "report/progress_bar.h"
#include "report/run_csv.h"
#include "scene/bodies.h"
#include "scene_options.h"
#include "simulation/drop_run.h"

namespace dgd_demos {
namespace {

bool IsRandom(const Scene& scene) {
  return std::ranges::any_of(scene.bodies,
                             [](const BodyGroup& group) { return std::holds_alternative<RandomPolytopes>(group); });
}

std::string NameOf(const Scene& scene) { return std::filesystem::path(scene.file).stem().string(); }

// Runs the scenes one after the other, and keeps what their tables cannot show.
class ContactReport {
 public:
  explicit ContactReport(const ContactReportOptions& options) : options_(options), csv_(options.out) {}

  void Add(const Scene& scene) {
    const int seeds = IsRandom(scene) ? options_.seeds : 1;
    std::vector<TableColumn> columns;
    for (const Narrowphase narrowphase : options_.narrowphases) {
      columns.push_back({std::string(dgd_demos::NameOf(narrowphase)), {}});
    }
    // Seed by seed, so that an interrupted report has the same seeds for all.
    for (int seed = 1; seed <= seeds; ++seed) {
      for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].runs.push_back(Run(scene, static_cast<std::uint64_t>(seed), options_.narrowphases[i]));
      }
    }
    Print(scene, seeds, columns);
  }

  ExitStatus status() const { return status_; }

 private:
  RunSummary Run(const Scene& scene, std::uint64_t seed, Narrowphase narrowphase) {
    const std::string name(dgd_demos::NameOf(narrowphase));
    const std::string label = NameOf(scene) + ", seed " + std::to_string(seed) + ", " + name;
    ProgressBar progress(label, scene.duration);
    const DropRun run = RunDrop(scene, MakeBodies(scene, seed), narrowphase, options_.oracle_every,
                                [&](const StepRecord& step) { progress.Update(step.time); });
    csv_.Write({NameOf(scene), seed, name, BulletPrecision(), DGD_DEMOS_BUILD_TYPE}, run.summary);
    if (run.failure) {
      failures_.push_back(label + ": " + *run.failure);
      status_ = kLostBody;
    }
    return run.summary;
  }

  void Print(const Scene& scene, int seeds, const std::vector<TableColumn>& columns) {
    std::printf("%s: %g s in steps of %g ms, Bullet in %s precision, %s\n", NameOf(scene).c_str(), scene.duration,
                1e3 * scene.time_step, BulletPrecision(),
                seeds == 1 ? "one run" : ("median of " + std::to_string(seeds) + " seeds").c_str());
    std::printf("%s\n", FormatTable(columns).c_str());
    std::fflush(stdout);
    for (const std::string& failure : failures_) std::fprintf(stderr, "%s\n", failure.c_str());
    failures_.clear();
  }

  const ContactReportOptions& options_;
  RunCsv csv_;
  std::vector<std::string> failures_;  // Of the scene that runs: told after its table.
  ExitStatus status_ = kSuccess;
};

ExitStatus Run(const ContactReportOptions& options) {
  std::vector<Scene> scenes;  // All of them first: a slip in the last should not show after minutes.
  for (const std::filesystem::path& file : options.scenes) scenes.push_back(LoadSceneFor(file, options.duration));

  if (options.out.has_parent_path()) std::filesystem::create_directories(options.out.parent_path());
  ContactReport report(options);
  for (const Scene& scene : scenes) report.Add(scene);
  std::printf("The figures of each run are in %s\n", options.out.c_str());
  return report.status();
}

}  // namespace
}  // namespace dgd_demos

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_demos::ParseCommandLine(argc, argv), dgd_demos::Run);
}
