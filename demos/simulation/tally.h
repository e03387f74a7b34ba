// The sums and extremes of a run as it goes.
#pragma once

#include <vector>

#include "checkpoint/state_archive.h"
#include "scene/pose.h"
#include "simulation/run_summary.h"
#include "simulation/simulated_body.h"
#include "simulation/step_record.h"

namespace dgd_demos {

class Tally {
 public:
  /// @param duration, time_step  s
  /// @param initial  energy before the first step.
  Tally(double duration, double time_step, std::vector<SimulatedBody> bodies, const Energy& initial);

  /// @param speeds  of all bodies after the step, in their order, m/s.
  void Add(const StepRecord& step, const std::vector<double>& speeds);

  int steps() const { return sums_.steps; }

  /// @param end_poses  of all bodies, in their order.
  /// @param wall_time  s
  RunSummary Summary(const std::vector<Pose>& end_poses, double wall_time) const;

  /// What was added so far; not what the constructor is given.
  void Serialize(StateArchive& archive);

 private:
  void AddEnergy(const StepRecord& step);
  void AddTruePenetration(const StepRecord& step);
  void AddSpeeds(const StepRecord& step, const std::vector<double>& speeds);
  void MeasureDisplacement(const std::vector<Pose>& end_poses, RunSummary& summary) const;

  std::vector<SimulatedBody> bodies_;
  double duration_, time_step_;  // s
  double initial_energy_;        // J
  RunSummary sums_;
  Energy energy_;        // At the end of the last step.
  double least_energy_;  // J, kinetic and potential, so far.
  double sum_of_true_ = 0;
  int oracle_steps_ = 0;
  double sum_of_squared_speeds_ = 0;  // Over the last half.
  int speeds_ = 0;
};

}  // namespace dgd_demos
