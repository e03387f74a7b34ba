#include "run/run_command.h"

#include <btBulletDynamicsCommon.h>
#include <dgd_bullet/recorder.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/continued_file.h"
#include "checkpoint/world_state.h"
#include "report/comparison_table.h"
#include "report/output_folder.h"
#include "report/pictures.h"
#include "report/progress_bar.h"
#include "report/step_csv.h"
#include "report/whole_file.h"
#include "run/trajectory.h"
#include "run/world_source.h"
#include "simulation/drop_run.h"
#include "stop_signals.h"

namespace dgd_demos {
namespace {

// The output for NumPy, as far as it is requested.
class Samples {
 public:
  Samples(const RunOptions& options, const std::string& name, SimulatedWorld& world, OpenMode mode)
      : world_(world), interval_(options.sample_interval) {
    if (options.write_trajectory) trajectory_.emplace(options.out / (name + "_trajectory.npy"), world, mode);
    if (options.write_contacts) contacts_.emplace(options.out / (name + "_contacts.npy"), mode);
    if (trajectory_ || contacts_) WriteBodyList(options.out / "bodies.csv", world);
    if (trajectory_ && mode == OpenMode::kCreate) trajectory_->Add(0, world);
  }

  void AddIfDue(double time) {
    // Half a step early rather than a whole one late.
    if (time + world_.time_step() / 2 < interval_ * static_cast<double>(count_ + 1)) return;
    ++count_;
    if (trajectory_) trajectory_->Add(time, world_);
    if (contacts_) contacts_->Add(time, world_);
  }

  void Flush() {
    if (trajectory_) trajectory_->Flush();
    if (contacts_) contacts_->Flush();
  }

  void AddState(StateArchive& archive) {
    archive.Add(count_);
    if (trajectory_) trajectory_->AddState(archive);
    if (contacts_) contacts_->AddState(archive);
  }

 private:
  SimulatedWorld& world_;
  double interval_;
  int count_ = 0;
  std::optional<TrajectoryFile> trajectory_;
  std::optional<ContactFile> contacts_;
};

// All that the results of a run depend on, to tell checkpoints of different runs apart.
nlohmann::json IdentityOf(const RunOptions& options, const WorldSource& source, const NarrowphaseChoice& narrowphase) {
  return {{"world", HashOf(ReadWholeFile(options.world))},
          {"seed", options.seed},
          {"narrowphase", narrowphase.Name()},
          {"precision", BulletPrecision()},
          {"Bullet's version", btGetVersion()},
          {"size of a contact point", sizeof(btManifoldPoint)},
          {"duration", source.duration()},
          {"time step", options.time_step.value_or(0)},
          {"oracle every", options.oracle_every},
          {"trajectory", options.write_trajectory},
          {"contacts", options.write_contacts},
          {"sample every", options.sample_interval}};
}

// A run with one narrowphase, the files that it writes, and its checkpoints.
class RecordedRun {
 public:
  RecordedRun(const WorldSource& source, const NarrowphaseChoice& narrowphase, const RunOptions& options)
      : name_(NameOf(narrowphase.kind)),
        identity_(IdentityOf(options, source, narrowphase)),
        checkpoint_file_(options.out / (name_ + ".checkpoint")),
        checkpoint_interval_(options.checkpoint_interval),
        checkpoint_(options.resume ? ReadCheckpoint(checkpoint_file_, identity_) : std::nullopt),
        mode_(checkpoint_ ? OpenMode::kContinue : OpenMode::kCreate),
        csv_(options.out / (name_ + ".csv"),
             {options.world.string(), options.seed, narrowphase.Name(), BulletPrecision(), DGD_DEMOS_BUILD_TYPE},
             mode_),
        world_(source.Make(narrowphase)),
        samples_(options, name_, *world_, mode_) {
    if (options.record) recorder_.emplace((options.out / (name_ + ".rec")).string());
    RunSettings settings{source.duration(), options.oracle_every};
    settings.snapshots = source.snapshots();
    run_.emplace(*world_, std::move(settings), recorder_ ? &*recorder_ : nullptr);
    if (checkpoint_) {
      AddState(*checkpoint_, {});
      checkpoint_->ExpectEnd();
      checkpoint_.reset();
    } else {
      std::filesystem::remove(checkpoint_file_);  // That of an earlier run in this folder.
    }
  }

  /// Runs to the end, or to the end of the step in which a stop is requested.
  void Go(double duration) {
    ProgressBar progress(name_ + std::string(8 - std::min<std::size_t>(name_.size(), 8), ' '), duration);
    auto last_checkpoint = Clock::now();
    while (!run_->IsDone() && !is_stopped_) {
      is_stopped_ = IsStopRequested();
      const std::chrono::duration<double> elapsed = Clock::now() - last_checkpoint;
      const bool is_due = checkpoint_interval_ && elapsed.count() >= *checkpoint_interval_;
      Step(is_due);
      if (is_due) last_checkpoint = Clock::now();
      progress.Update(run_->time());
    }
    csv_.Flush();
    samples_.Flush();
    if (recorder_) recorder_->Close();
  }

  bool IsDone() const { return run_->IsDone(); }
  DropRun Result() const { return run_->Result(); }

 private:
  using Clock = std::chrono::steady_clock;

  // The last step gets a checkpoint as well.
  void Step(bool checkpoint_is_due) {
    std::vector<btTransform> collision_poses;
    if (checkpoint_interval_) collision_poses = PosesOf(world_->Bullet());
    const StepRecord step = run_->Step();
    csv_.Write(step);
    samples_.AddIfDue(step.time);
    if (!checkpoint_interval_ || !(checkpoint_is_due || run_->IsDone() || is_stopped_)) return;
    StateArchive state;
    AddState(state, std::move(collision_poses));
    WriteCheckpoint(checkpoint_file_, identity_, state);
  }

  void AddState(StateArchive& archive, std::vector<btTransform> collision_poses) {
    AddWorld(archive, world_->Bullet(), std::move(collision_poses));
    run_->AddState(archive);
    csv_.AddState(archive);
    samples_.AddState(archive);
  }

  std::string name_;
  nlohmann::json identity_;
  std::filesystem::path checkpoint_file_;
  std::optional<double> checkpoint_interval_;  // Wall time, s.
  std::optional<StateArchive> checkpoint_;     // To continue from.
  OpenMode mode_;
  StepCsv csv_;
  std::optional<dgd_bullet::Recorder> recorder_;
  std::unique_ptr<SimulatedWorld> world_;
  Samples samples_;
  std::optional<WorldRun> run_;
  bool is_stopped_ = false;
};

// A stopped run has no table: its figures are those of a run to the end.
void PrintStop(const RecordedRun& run, const RunOptions& options) {
  std::fprintf(stderr, "Stopped at %g s of the simulation. %s\n", run.Result().end_state.time,
               options.checkpoint_interval
                   ? "The same command with --resume continues the run."
                   : "Files are complete up to there; only runs with --checkpoint can be continued.");
}

}  // namespace

ExitStatus Run(const RunOptions& options) {
  const WorldSource source({options.world, options.seed, options.duration, options.time_step});
  for (const std::string& remark : source.remarks()) std::fprintf(stderr, "%s\n", remark.c_str());
  std::vector<NarrowphaseChoice> narrowphases;
  for (const std::string& name : options.narrowphases) narrowphases.push_back(NarrowphaseChoice::Named(name));
  MakeOutputFolder(options.out);

  std::vector<NamedRun> runs;
  std::vector<TableColumn> columns;
  CatchStopSignals();
  for (const NarrowphaseChoice& narrowphase : narrowphases) {
    RecordedRun run(source, narrowphase, options);
    run.Go(source.duration());
    if (!run.IsDone()) {
      PrintStop(run, options);
      return kInterrupted;
    }
    runs.push_back({narrowphase.kind, run.Result()});
    columns.push_back({std::string(NameOf(narrowphase.kind)), {FiguresOf(runs.back().run.summary)}});
  }
  const WorldView view = options.draw_snapshots ? source.View() : WorldView{};
  if (!view.bodies.empty()) {
    WritePictures(view, source.scene() ? std::optional(options.seed) : std::nullopt, runs, options.out);
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
