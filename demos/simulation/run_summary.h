// The figures of a whole run, free of Bullet.
#pragma once

#include <cstdint>
#include <limits>

namespace dgd_demos {

/// J. A scene in which all bodies together have less is at rest.
inline constexpr double kRestEnergy = 0.01;

/// Figures that a run does not have, because it ended before or the oracle was not run; and a time that never came.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kNever = std::numeric_limits<double>::infinity();

struct RunSummary {
  int steps = 0;
  double deepest_reported = 0;     ///< m, over all steps.
  double deepest_true = 0;         ///< m, over the steps at which the oracle was run.
  double mean_true = 0;            ///< m, mean over those steps of the deepest in each.
  double deepest_at_rest = kNone;  ///< m, as deepest_true, over the last second of the scene.
  double time_to_rest = kNever;    ///< s, from when on the kinetic energy stays below kRestEnergy to the end.
  double kinetic_energy_end = 0;   ///< J
  double dissipated_share = 0;     ///< Share of the initial energy, kinetic and potential.
  double energy_rise_step = 0;     ///< J, largest rise of the total energy over one step.
  double energy_rise = 0;          ///< J, largest rise of the total energy above its least so far.
  double rms_speed = kNone;     ///< m/s, of the centres of mass, over all moving bodies and the last half of the scene.
  double displacement = 0;      ///< m, the largest from a body's start to its end.
  int out_of_place = 0;         ///< Bodies that end farther from their start than half their radius; see DropRun.
  int lost_bodies = 0;          ///< 1 if the run ended early, because a body left the world or was not finite.
  std::uint64_t pairs = 0;      ///< Over all steps.
  std::uint64_t queries = 0;    ///< Over all steps.
  double narrowphase_us = 0;    ///< Over all steps.
  std::uint64_t contacts = 0;   ///< Over all steps.
  std::uint64_t fallbacks = 0;  ///< Over all steps.
  std::uint64_t unjudged_pairs = 0;  ///< Over the steps at which the oracle was run; see StepRecord.
  double wall_time = 0;              ///< Time of Bullet's steps alone, s: without the oracle, files and pictures.
};

}  // namespace dgd_demos
