#include "run/run_command.h"

#include <dgd_bullet/recorder.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/comparison_table.h"
#include "report/pictures.h"
#include "report/progress_bar.h"
#include "report/step_csv.h"
#include "run/trajectory.h"
#include "scene/bodies.h"
#include "scene_options.h"
#include "simulation/drop_run.h"
#include "simulation/world.h"

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

DropRun RunAndRecord(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase,
                     const RunOptions& options) {
  const std::string name(NameOf(narrowphase.kind));
  StepCsv csv(options.out / (name + ".csv"),
              {scene.file, options.seed, narrowphase.Name(), BulletPrecision(), DGD_DEMOS_BUILD_TYPE});
  ProgressBar progress(name + std::string(8 - std::min<std::size_t>(name.size(), 8), ' '), scene.duration);
  std::optional<dgd_bullet::Recorder> recorder;
  if (options.record) recorder.emplace((options.out / (name + ".rec")).string());
  World world(scene, bodies, narrowphase);
  Samples samples(options, name, world);
  const auto on_step = [&](const StepRecord& step) {
    csv.Write(step);
    samples.AddIfDue(step.time);
    progress.Update(step.time);
  };
  DropRun run = RunWorld(world, {scene.duration, options.oracle_every, scene.snapshots}, on_step,
                         recorder ? &*recorder : nullptr);
  if (recorder) recorder->Close();
  return run;
}

}  // namespace

ExitStatus Run(const RunOptions& options) {
  const Scene scene = LoadSceneFor(options.world, options.duration);
  const std::vector<Body> bodies = MakeBodies(scene, options.seed);
  std::vector<NarrowphaseChoice> narrowphases;
  for (const std::string& name : options.narrowphases) narrowphases.push_back(NarrowphaseChoice::Named(name));
  std::filesystem::create_directories(options.out);

  std::vector<NamedRun> runs;
  std::vector<TableColumn> columns;
  for (const NarrowphaseChoice& narrowphase : narrowphases) {
    runs.push_back({narrowphase.kind, RunAndRecord(scene, bodies, narrowphase, options)});
    columns.push_back({std::string(NameOf(narrowphase.kind)), {FiguresOf(runs.back().run.summary)}});
  }
  if (options.draw_snapshots) WritePictures(scene, bodies, options.seed, runs, options.out);

  WriteTableCsv(options.out / "summary.csv", columns);
  std::printf("%s, seed %llu, Bullet in %s precision\n\n%s\nResults are in %s\n", scene.file.c_str(),
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
