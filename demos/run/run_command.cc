#include "run/run_command.h"

#include <dgd_bullet/recorder.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/comparison_table.h"
#include "report/pictures.h"
#include "report/progress_bar.h"
#include "report/step_csv.h"
#include "run/trajectory.h"
#include "run/world_source.h"
#include "simulation/drop_run.h"

namespace dgd_demos {
namespace {

// What a run leaves for NumPy, if asked for.
class Samples {
 public:
  Samples(const RunOptions& options, const std::string& name, SimulatedWorld& world)
      : world_(world), interval_(options.sample_interval) {
    if (options.write_trajectory) trajectory_.emplace(options.out / (name + "_trajectory.npy"), world);
    if (options.write_contacts) contacts_.emplace(options.out / (name + "_contacts.npy"));
    if (trajectory_ || contacts_) WriteBodyList(options.out / "bodies.csv", world);
    if (trajectory_) trajectory_->Add(0, world);
  }

  void AddIfDue(double time) {
    // Half a step early rather than a whole one late.
    if (time + world_.time_step() / 2 < interval_ * static_cast<double>(count_ + 1)) return;
    ++count_;
    if (trajectory_) trajectory_->Add(time, world_);
    if (contacts_) contacts_->Add(time, world_);
  }

 private:
  SimulatedWorld& world_;
  double interval_;
  int count_ = 0;
  std::optional<TrajectoryFile> trajectory_;
  std::optional<ContactFile> contacts_;
};

DropRun RunAndRecord(const WorldSource& source, const NarrowphaseChoice& narrowphase, const RunOptions& options) {
  const std::string name(NameOf(narrowphase.kind));
  StepCsv csv(options.out / (name + ".csv"),
              {options.world.string(), options.seed, narrowphase.Name(), BulletPrecision(), DGD_DEMOS_BUILD_TYPE});
  ProgressBar progress(name + std::string(8 - std::min<std::size_t>(name.size(), 8), ' '), source.duration());
  std::optional<dgd_bullet::Recorder> recorder;
  if (options.record) recorder.emplace((options.out / (name + ".rec")).string());
  const std::unique_ptr<SimulatedWorld> world = source.Make(narrowphase);
  Samples samples(options, name, *world);
  const auto on_step = [&](const StepRecord& step) {
    csv.Write(step);
    samples.AddIfDue(step.time);
    progress.Update(step.time);
  };
  RunSettings settings{source.duration(), options.oracle_every};
  if (source.scene()) settings.snapshots = source.scene()->snapshots;
  DropRun run = RunWorld(*world, settings, on_step, recorder ? &*recorder : nullptr);
  if (recorder) recorder->Close();
  return run;
}

}  // namespace

ExitStatus Run(const RunOptions& options) {
  const WorldSource source({options.world, options.seed, options.duration, options.time_step});
  for (const std::string& remark : source.remarks()) std::fprintf(stderr, "%s\n", remark.c_str());
  std::vector<NarrowphaseChoice> narrowphases;
  for (const std::string& name : options.narrowphases) narrowphases.push_back(NarrowphaseChoice::Named(name));
  std::filesystem::create_directories(options.out);

  std::vector<NamedRun> runs;
  std::vector<TableColumn> columns;
  for (const NarrowphaseChoice& narrowphase : narrowphases) {
    runs.push_back({narrowphase.kind, RunAndRecord(source, narrowphase, options)});
    columns.push_back({std::string(NameOf(narrowphase.kind)), {FiguresOf(runs.back().run.summary)}});
  }
  if (options.draw_snapshots && source.scene()) {
    WritePictures(*source.scene(), source.bodies(), options.seed, runs, options.out);
  }

  WriteTableCsv(options.out / "summary.csv", columns);
  std::printf("%s, seed %llu, Bullet in %s precision\n\n%s\nResults are in %s\n", options.world.c_str(),
              static_cast<unsigned long long>(options.seed), BulletPrecision(), FormatTable(columns).c_str(),
              options.out.c_str());

  ExitStatus status = kSuccess;
  for (const NamedRun& run : runs) {
    if (!run.run.failure) continue;
    std::fprintf(stderr, "%s: %s\n", std::string(NameOf(run.narrowphase)).c_str(), run.run.failure->c_str());
    status = kLostBody;
  }
  return status;
}

}  // namespace dgd_demos
