// One run of a world with one narrowphase, from the first step to the table's figures. Every program and test that
// simulates a scene or a world file does it by these functions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/state_archive.h"
#include "dgd_bullet/options.h"
#include "scene/bodies.h"
#include "scene/scene.h"
#include "simulation/narrowphase.h"
#include "simulation/penetration_oracle.h"
#include "simulation/run_summary.h"
#include "simulation/simulated_world.h"
#include "simulation/snapshot.h"
#include "simulation/step_record.h"
#include "simulation/tally.h"

namespace dgd_demos {

struct DropRun {
  RunSummary summary;
  std::vector<Snapshot> snapshots;     ///< At the scene's times, as far as the run got.
  Snapshot end_state;                  ///< After the last step.
  std::optional<std::string> failure;  ///< Which body was lost, and when; the run ended there.
};

struct RunSettings {
  double duration;                     ///< s
  int oracle_every = 1;                ///< Compute the true penetration at every so-many-th step, >= 1.
  std::vector<double> snapshots = {};  ///< Times of the pictures, s, ascending.
};

/// A run of any world, from where it is, step by step.
class WorldRun {
 public:
  /// @param world     must outlive this.
  /// @param observer  is shown the queries of the narrowphase, or null; must outlive this.
  WorldRun(SimulatedWorld& world, RunSettings settings, dgd_bullet::PairObserver* observer = nullptr);
  WorldRun(const WorldRun&) = delete;
  WorldRun& operator=(const WorldRun&) = delete;

  /// Whether the duration is over, or a body is lost.
  bool IsDone() const;
  double time() const { return tally_.steps() * world_.time_step(); }  ///< Simulated so far, s.
  /// @pre !IsDone().
  StepRecord Step();
  /// The run so far.
  DropRun Result() const;

  /// All but the world's own state. Reading continues a run that was written with the same settings.
  void Serialize(StateArchive& archive);

 private:
  void TakeDueSnapshots(double time);

  SimulatedWorld& world_;
  RunSettings settings_;
  int step_count_;
  PenetrationOracle oracle_;
  Tally tally_;
  double wall_time_ = 0;  // Of the world's steps, s.
  std::vector<Snapshot> snapshots_;
  std::optional<std::string> failure_;
};

/// The whole of a run.
/// @param on_step   called after each step.
DropRun RunWorld(SimulatedWorld& world, const RunSettings& settings,
                 const std::function<void(const StepRecord&)>& on_step, dgd_bullet::PairObserver* observer = nullptr);

/// @param bodies        from MakeBodies().
/// @param oracle_every  see RunSettings.
/// @param on_step       called after each step.
/// @param observer      see WorldRun.
DropRun RunDrop(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase,
                int oracle_every, const std::function<void(const StepRecord&)>& on_step,
                dgd_bullet::PairObserver* observer = nullptr);

/// Number of steps that a scene takes.
int StepCount(const Scene& scene);

}  // namespace dgd_demos
