// A run with one narrowphase, with the files that it writes and its checkpoints.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/continued_file.h"
#include "checkpoint/state_archive.h"
#include "report/step_csv.h"
#include "run/pair_recorder.h"
#include "run/run_options.h"
#include "run/trajectory.h"
#include "run/world_source.h"
#include "simulation/drop_run.h"
#include "simulation/narrowphase.h"
#include "simulation/simulated_world.h"

class btTransform;

namespace dgd_demos {

/// Trajectory and contacts for NumPy, as far as they are requested.
class SampleFiles {
 public:
  /// @param name   begins the names of the files: "dgd".
  /// @param world  must outlive this.
  /// @throws std::runtime_error if a file cannot be written.
  SampleFiles(const RunOptions& options, const std::string& name, SimulatedWorld& world, OpenMode mode);

  /// Adds a sample if RunOptions::sample_interval has passed since the last one.
  /// @param time  simulated so far, s.
  void AddIfDue(double time);
  void Flush();
  void Serialize(StateArchive& archive);

 private:
  SimulatedWorld& world_;
  double interval_;  // s
  int count_ = 0;
  std::optional<TrajectoryFile> trajectory_;
  std::optional<ContactFile> contacts_;
};

class RecordedRun {
 public:
  /// Begins the run, or continues it from its checkpoint if RunOptions::resume says so and there is one.
  /// @param source  must outlive this.
  /// @throws std::runtime_error if the checkpoint is damaged or of another run, or if a file cannot be written.
  RecordedRun(const WorldSource& source, const NarrowphaseChoice& narrowphase, const RunOptions& options);

  /// Runs to the end, or to the end of a step in which a stop is requested; see StopSignals.
  void Run();

  bool IsDone() const { return run_->IsDone(); }
  double time() const { return run_->time(); }  ///< Simulated so far, s.
  DropRun Result() const { return run_->Result(); }

 private:
  void Step(bool checkpoint_is_due);
  void Serialize(StateArchive& archive, std::vector<btTransform> collision_poses);

  std::string name_;                      // "builtin" or "dgd".
  double duration_;                       // s
  std::optional<PairRecorder> recorder_;  // Outlives the world.
  std::unique_ptr<SimulatedWorld> world_;
  nlohmann::json identity_;  // All that the results depend on; see WriteCheckpoint().
  std::filesystem::path checkpoint_file_;
  std::optional<double> checkpoint_interval_;  // Wall time, s.
  std::optional<StateArchive> checkpoint_;     // To continue from.
  OpenMode mode_;
  StepCsv csv_;
  SampleFiles samples_;
  std::optional<WorldRun> run_;
  bool is_stopped_ = false;
};

}  // namespace dgd_demos
