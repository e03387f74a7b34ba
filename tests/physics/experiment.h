// What an experiment is: a few cases with a known result, run on one narrowphase at one rate. Knows no Bullet.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dgd_physics {

enum class Narrowphase { kBuiltin, kOurs };

/// Under what an experiment runs.
struct Conditions {
  Narrowphase narrowphase = Narrowphase::kBuiltin;
  double rate = 60;       ///< Steps per second.
  bool is_quick = false;  ///< Fewer cases.
  /// Whether each convex body's shape is the only child of a compound, static bodies' as well.
  bool in_compounds = false;
};

/// One measured quantity of one case.
struct Sample {
  std::string name;     ///< The case and the quantity: "box 0.4 rad 1 m/s: distance".
  double measured = 0;  ///< In the experiment's unit.
  double theory = 0;    ///< Same unit.
  double scale = 1;     ///< What the error is relative to; same unit, > 0.
  std::string group;    ///< Of the cases of a class, those that are also judged by themselves; may be empty.
};
using Samples = std::vector<Sample>;

/// A sample whose error is relative to the theory itself, which must not be 0.
Sample RelativeToTheory(std::string name, double measured, double theory, std::string group = {});

/// Appends.
void AddTo(Samples& samples, Samples more);

/// |measured - theory| / scale, at most 1; 1 for NaN.
double RelativeError(const Sample& sample);

/// Root mean square of the relative errors; 1 without samples.
double RmsError(const Samples& samples);

/// A class of cases.
struct Experiment {
  std::string_view name;
  std::string_view summary;  ///< One line: what moves, and what the error is relative to.
  Samples (*measure)(const Conditions& conditions);
  bool is_restitution = false;  ///< Also has an absolute bound.
};

/// All of them, in the order of the table.
const std::vector<Experiment>& Experiments();

/// The largest error of ours that passes, by the built-in's error in the same run, and by rate for restitution.
double ErrorBound(const Experiment& experiment, double rate, double builtin_error);

/// All cases, or in a quick run only some: every `stride`-th, from the first.
template <class Case>
std::vector<Case> SelectCases(const Conditions& conditions, const std::vector<Case>& all, std::size_t stride) {
  if (!conditions.is_quick) return all;
  std::vector<Case> few;
  for (std::size_t i = 0; i < all.size(); i += stride) few.push_back(all[i]);
  return few;
}

/// A sample for each case, or in a quick run for some, as SelectCases() does it.
/// @param measure  Sample(const Conditions&, const Case&).
template <class Case, class Measure>
Samples MeasureCases(const Conditions& conditions, const std::vector<Case>& all, std::size_t stride,
                     const Measure& measure) {
  Samples samples;
  for (std::size_t i = 0; i < all.size(); i += conditions.is_quick ? stride : 1)
    samples.push_back(measure(conditions, all[i]));
  return samples;
}

/// 0 to count - 1, or in a quick run every `stride`-th of them.
std::vector<int> SelectIndices(const Conditions& conditions, int count, int stride);

}  // namespace dgd_physics
