#include "run/recorded_run.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/world_state.h"
#include "report/progress_bar.h"
#include "report/whole_file.h"
#include "scene/world_hash.h"
#include "stop_signals.h"

namespace dgd_demos {
namespace {

using Clock = std::chrono::steady_clock;

// All that the results of a run depend on, to tell checkpoints of different runs apart.
nlohmann::json IdentityOf(const RunOptions& options, const WorldSource& source, const NarrowphaseChoice& narrowphase,
                          const SimulatedWorld& world) {
  return {{"hash of the world's files", HashOfWorld(options.world)},
          {"--seed", options.seed},
          {"narrowphase", narrowphase.Name()},
          {"precision", BulletPrecision()},
          {"Bullet's version", btGetVersion()},
          {"size of a contact point", sizeof(btManifoldPoint)},
          {"duration", source.duration()},
          {"time step", world.time_step()},
          {"--oracle-every", options.oracle_every},
          {"--trajectory", options.write_trajectory},
          {"--contacts", options.write_contacts},
          {"--sample-every", options.sample_interval}};
}

}  // namespace

SampleFiles::SampleFiles(const RunOptions& options, const std::string& name, SimulatedWorld& world, OpenMode mode)
    : world_(world), interval_(options.sample_interval) {
  if (options.write_trajectory) trajectory_.emplace(options.out / (name + "_trajectory.npy"), world, mode);
  if (options.write_contacts) contacts_.emplace(options.out / (name + "_contacts.npy"), mode);
  if (trajectory_ || contacts_) WriteBodyList(options.out / "bodies.csv", world);
  if (trajectory_ && mode == OpenMode::kCreate) trajectory_->Add(0, world);
}

void SampleFiles::AddIfDue(double time) {
  // Half a step early rather than a whole one late.
  if (time + world_.time_step() / 2 < interval_ * (static_cast<double>(count_) + 1)) return;
  ++count_;
  if (trajectory_) trajectory_->Add(time, world_);
  if (contacts_) contacts_->Add(time, world_);
}

void SampleFiles::Flush() {
  if (trajectory_) trajectory_->Flush();
  if (contacts_) contacts_->Flush();
}

void SampleFiles::Serialize(StateArchive& archive) {
  archive.Serialize(count_);
  if (trajectory_) trajectory_->Serialize(archive);
  if (contacts_) contacts_->Serialize(archive);
}

RecordedRun::RecordedRun(const WorldSource& source, const NarrowphaseChoice& narrowphase, const RunOptions& options)
    : name_(NameOf(narrowphase.kind)),
      duration_(source.duration()),
      world_(source.Make(narrowphase)),
      identity_(IdentityOf(options, source, narrowphase, *world_)),
      checkpoint_file_(options.out / (name_ + ".checkpoint")),
      checkpoint_interval_(options.checkpoint_interval),
      checkpoint_(options.resume ? ReadCheckpoint(checkpoint_file_, identity_) : std::nullopt),
      mode_(checkpoint_ ? OpenMode::kContinue : OpenMode::kCreate),
      csv_(options.out / (name_ + ".csv"),
           {options.world.string(), options.seed, narrowphase.Name(), BulletPrecision(), DGD_DEMOS_BUILD_TYPE}, mode_),
      samples_(options, name_, *world_, mode_) {
  RemoveParts(checkpoint_file_);
  if (options.record) {
    const std::filesystem::path file = options.out / (name_ + ".rec");
    // The recorder would write through a link.
    if (std::FILE* const stream = CreateFile(file)) std::fclose(stream);
    recorder_.emplace(file.string());
  }
  run_.emplace(*world_, RunSettings{duration_, options.oracle_every, source.snapshots()},
               recorder_ ? &*recorder_ : nullptr);
  if (checkpoint_) {
    Serialize(*checkpoint_, {});
    checkpoint_->ExpectEnd();
    checkpoint_.reset();
  } else {
    std::filesystem::remove(checkpoint_file_);  // Left by an earlier run in this folder.
  }
}

void RecordedRun::Run() {
  ProgressBar progress(name_ + std::string(8 - std::min<std::size_t>(name_.size(), 8), ' '), duration_);
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

// The last step gets a checkpoint as well.
void RecordedRun::Step(bool checkpoint_is_due) {
  std::vector<btTransform> collision_poses;
  if (checkpoint_interval_) collision_poses = PosesOf(world_->Bullet());
  const StepRecord step = run_->Step();
  if (recorder_) recorder_->NextStep();
  csv_.Write(step);
  samples_.AddIfDue(step.time);
  if (!checkpoint_interval_ || !(checkpoint_is_due || run_->IsDone() || is_stopped_)) return;
  StateArchive state;
  Serialize(state, std::move(collision_poses));
  WriteCheckpoint(checkpoint_file_, identity_, state);
}

void RecordedRun::Serialize(StateArchive& archive, std::vector<btTransform> collision_poses) {
  SerializeWorld(archive, world_->Bullet(), std::move(collision_poses));
  run_->Serialize(archive);
  csv_.Serialize(archive);
  samples_.Serialize(archive);
}

}  // namespace dgd_demos
