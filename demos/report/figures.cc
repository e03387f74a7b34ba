#include "report/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace dgd_demos {
namespace {

double PerStep(double sum, const RunSummary& run) { return sum / run.steps; }

constexpr std::array kFigures = {
    Figure{"deepest penetration, reported (cm)", "deepest_reported_penetration_m", "%.3f", 1e-2,
           [](const RunSummary& run) { return run.deepest_reported; }},
    Figure{"deepest penetration, true (cm)", "deepest_true_penetration_m", "%.3f", 1e-2,
           [](const RunSummary& run) { return run.deepest_true; }},
    Figure{"  the deepest of a step, mean (cm)", "mean_true_penetration_m", "%.4f", 1e-2,
           [](const RunSummary& run) { return run.mean_true; }},
    Figure{"  the deepest in the last second (cm)", "deepest_at_rest_m", "%.3g", 1e-2,
           [](const RunSummary& run) { return run.deepest_at_rest; }},
    Figure{"  pairs that could not be judged", "unjudged_pairs", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.unjudged_pairs); }, Figure::Over::kSum},
    Figure{"time to rest (s)", "time_to_rest_s", "%.3f", 1, [](const RunSummary& run) { return run.time_to_rest; }},
    Figure{"kinetic energy at the end (J)", "kinetic_energy_end_j", "%.4f", 1,
           [](const RunSummary& run) { return run.kinetic_energy_end; }},
    Figure{"energy dissipated (%)", "energy_dissipated_share", "%.2f", 1e-2,
           [](const RunSummary& run) { return run.dissipated_share; }},
    Figure{"largest rise of energy in a step (J)", "energy_rise_step_j", "%.3g", 1,
           [](const RunSummary& run) { return run.energy_rise_step; }},
    Figure{"  above its least so far (J)", "energy_rise_j", "%.3g", 1,
           [](const RunSummary& run) { return run.energy_rise; }},
    Figure{"rms speed in the last half (mm/s)", "rms_speed_m_s", "%.3g", 1e-3,
           [](const RunSummary& run) { return run.rms_speed; }},
    Figure{"farthest from its start (mm)", "displacement_m", "%.4g", 1e-3,
           [](const RunSummary& run) { return run.displacement; }},
    Figure{"bodies out of place", "out_of_place", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.out_of_place); }},
    Figure{"bodies lost", "lost_bodies", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.lost_bodies); }, Figure::Over::kSum},
    Figure{"pairs of overlapping boxes", "pairs", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.pairs); }},
    Figure{"  of these queried (not asleep)", "queries", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.queries); }},
    Figure{"narrowphase per queried pair (us)", "narrowphase_us_per_query", "%.3f", 1,
           [](const RunSummary& run) { return run.narrowphase_us / static_cast<double>(run.queries); }},
    Figure{"contacts, mean over steps", "contacts_mean", "%.1f", 1,
           [](const RunSummary& run) { return PerStep(static_cast<double>(run.contacts), run); }},
    Figure{"fallbacks to GJK/EPA", "fallbacks", "%.0f", 1,
           [](const RunSummary& run) { return static_cast<double>(run.fallbacks); }, Figure::Over::kSum},
    Figure{"wall time of the steps (s)", "wall_time_s", "%.2f", 1, [](const RunSummary& run) { return run.wall_time; }},
};

// The value below which a share of them lies; between two neighbours, in proportion.
double Quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(below);
  // Not by lerp where there is nothing in between: infinite neighbours have no difference.
  return rest == 0 ? sorted[below] : std::lerp(sorted[below], sorted[below + 1], rest);
}

}  // namespace

std::span<const Figure> Figures() { return kFigures; }

FigureValues FiguresOf(const RunSummary& run) {
  FigureValues values;
  for (const Figure& figure : kFigures) values.push_back(figure.of(run));
  return values;
}

FigureOverRuns FigureOf(std::size_t figure, std::span<const FigureValues> runs) {
  std::vector<double> values;
  for (const FigureValues& run : runs) values.push_back(run[figure]);
  if (kFigures[figure].over == Figure::Over::kSum) {
    return {std::accumulate(values.begin(), values.end(), 0.0), kNone};
  }
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {kNone, kNone};
  std::ranges::sort(values);
  return {Quantile(values, 0.5), values.size() < 2 ? kNone : Quantile(values, 0.75) - Quantile(values, 0.25)};
}

}  // namespace dgd_demos
