#include "simulation/tally.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgd_demos {
namespace {

// "At rest" is the end of a run, by when a scene should have come to rest.
constexpr double kEndOfRun = 1;  // s

// A body has left its place when its centre has moved by more than this share of its radius: a box or a domino that
// topples does so, one that merely creeps does not.
constexpr double kPlaceShare = 0.5;

double Total(const Energy& energy) { return energy.kinetic + energy.potential; }

}  // namespace

Tally::Tally(double duration, double time_step, std::vector<SimulatedBody> bodies, const Energy& initial)
    : bodies_(std::move(bodies)),
      duration_(duration),
      time_step_(time_step),
      initial_energy_(Total(initial)),
      energy_(initial),
      least_energy_(Total(initial)) {
  sums_.time_to_rest = 0;
}

void Tally::Add(const StepRecord& step, const std::vector<double>& speeds) {
  ++sums_.steps;
  sums_.deepest_reported = std::max(sums_.deepest_reported, step.collision.deepest_penetration);
  sums_.pairs += static_cast<std::uint64_t>(step.collision.pairs);
  sums_.queries += static_cast<std::uint64_t>(step.collision.queries);
  sums_.narrowphase_us += step.collision.narrowphase_us;
  sums_.contacts += static_cast<std::uint64_t>(step.collision.contacts);
  sums_.fallbacks += step.collision.fallbacks;
  sums_.unjudged_pairs += static_cast<std::uint64_t>(step.unjudged_pairs);
  AddEnergy(step);
  AddTruePenetration(step);
  AddSpeeds(step, speeds);
}

void Tally::AddEnergy(const StepRecord& step) {
  const double total = Total(step.energy);
  sums_.energy_rise_step = std::max(sums_.energy_rise_step, total - Total(energy_));
  sums_.energy_rise = std::max(sums_.energy_rise, total - least_energy_);
  least_energy_ = std::min(least_energy_, total);
  energy_ = step.energy;
  if (step.energy.kinetic >= kRestEnergy) sums_.time_to_rest = step.time;
}

void Tally::AddTruePenetration(const StepRecord& step) {
  if (!step.true_penetration) return;
  ++oracle_steps_;
  sum_of_true_ += *step.true_penetration;
  sums_.deepest_true = std::max(sums_.deepest_true, *step.true_penetration);
  // fmax: the first takes the place of kNone.
  if (step.time > duration_ - kEndOfRun) {
    sums_.deepest_at_rest = std::fmax(sums_.deepest_at_rest, *step.true_penetration);
  }
}

void Tally::AddSpeeds(const StepRecord& step, const std::vector<double>& speeds) {
  if (step.time <= duration_ / 2) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].moves) continue;
    sum_of_squared_speeds_ += speeds[i] * speeds[i];
    ++speeds_;
  }
}

void Tally::MeasureDisplacement(const std::vector<Pose>& end_poses, RunSummary& summary) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const SimulatedBody& body = bodies_[i];
    const double displacement = (end_poses[i].position - body.start).norm();
    summary.displacement = std::max(summary.displacement, displacement);
    const bool in_place = displacement <= kPlaceShare * body.radius;  // False for NaN.
    if (!in_place) ++summary.out_of_place;
  }
}

RunSummary Tally::Summary(const std::vector<Pose>& end_poses, double wall_time) const {
  RunSummary summary = sums_;
  summary.mean_true = sum_of_true_ / std::max(1, oracle_steps_);
  summary.kinetic_energy_end = energy_.kinetic;
  // Of nothing, there is no share.
  summary.dissipated_share = initial_energy_ == 0 ? kNone : 1 - Total(energy_) / initial_energy_;
  summary.wall_time = wall_time;
  if (speeds_ > 0) summary.rms_speed = std::sqrt(sum_of_squared_speeds_ / speeds_);
  const bool ended_early = sums_.steps * time_step_ < duration_ - time_step_ / 2;
  if (ended_early || !(energy_.kinetic < kRestEnergy)) summary.time_to_rest = kNever;
  MeasureDisplacement(end_poses, summary);
  return summary;
}

void Tally::Serialize(StateArchive& archive) {
  archive.Serialize(initial_energy_);
  archive.Serialize(sums_);
  archive.Serialize(energy_);
  archive.Serialize(least_energy_);
  archive.Serialize(sum_of_true_);
  archive.Serialize(oracle_steps_);
  archive.Serialize(sum_of_squared_speeds_);
  archive.Serialize(speeds_);
  archive.Require(0 <= oracle_steps_ && oracle_steps_ <= sums_.steps && 0 <= speeds_, "a count is out of range");
}

}  // namespace dgd_demos
