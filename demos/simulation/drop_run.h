// One run of a world with one narrowphase, from the first step to the table's figures. Every program and test that
// simulates a scene or a world file does it by these functions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dgd_bullet/recorder.h"
#include "scene/bodies.h"
#include "scene/scene.h"
#include "simulation/narrowphase.h"
#include "simulation/run_summary.h"
#include "simulation/simulated_world.h"
#include "simulation/snapshot.h"
#include "simulation/step_record.h"

namespace dgd_demos {

struct DropRun {
  RunSummary summary;
  std::vector<Snapshot> snapshots;     ///< At the scene's times, as far as the run got.
  Snapshot end_state;                  ///< After the last step.
  std::optional<std::string> failure;  ///< Which body was lost, and when; the run ended there.
};

struct RunSettings {
  double duration;                     ///< s
  int oracle_every = 1;                ///< Ask the oracle at every so-many-th step, >= 1.
  std::vector<double> snapshots = {};  ///< Times of the pictures, s, ascending.
};

/// The same of any world, from where it is.
/// @param on_step   called after each step.
/// @param recorder  gets what the narrowphase is asked, or null.
DropRun RunWorld(SimulatedWorld& world, const RunSettings& settings,
                 const std::function<void(const StepRecord&)>& on_step, dgd_bullet::Recorder* recorder = nullptr);

/// @param bodies        from MakeBodies().
/// @param oracle_every  ask the oracle at every so-many-th step, >= 1.
/// @param on_step       called after each step.
/// @param recorder      gets what the narrowphase is asked, or null.
DropRun RunDrop(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase,
                int oracle_every, const std::function<void(const StepRecord&)>& on_step,
                dgd_bullet::Recorder* recorder = nullptr);

/// Number of steps that a scene takes.
int StepCount(const Scene& scene);

}  // namespace dgd_demos
