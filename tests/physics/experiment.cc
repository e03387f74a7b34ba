#include "physics/experiment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgd_physics {
namespace {

/// By how much ours may exceed the built-in: relative, and absolute.
constexpr double kAllowedRatio = 1.1;
constexpr double kAllowedExcess = 0.003;

/// Largest error of a rebound, by rate.
double RestitutionBound(double rate) {
  if (rate < 240) return 0.02;
  return rate < 1000 ? 0.01 : 0.005;
}

}  // namespace

Sample RelativeToTheory(std::string name, double measured, double theory, std::string group) {
  return {std::move(name), measured, theory, std::abs(theory), std::move(group)};
}

void AddTo(Samples& samples, Samples more) {
  for (Sample& sample : more) samples.push_back(std::move(sample));
}

double RelativeError(const Sample& sample) {
  const double error = std::abs(sample.measured - sample.theory) / sample.scale;
  return error <= 1 ? error : 1;  // False for NaN.
}

double RmsError(const Samples& samples) {
  if (samples.empty()) return 1;
  double squares = 0;
  for (const Sample& sample : samples) squares += RelativeError(sample) * RelativeError(sample);
  return std::sqrt(squares / double(samples.size()));
}

double ErrorBound(const Experiment& experiment, double rate, double builtin_error) {
  const double bound = kAllowedRatio * builtin_error + kAllowedExcess;
  return experiment.is_restitution ? std::min(bound, RestitutionBound(rate)) : bound;
}

std::vector<int> SelectIndices(const Conditions& conditions, int count, int stride) {
  std::vector<int> indices;
  for (int i = 0; i < count; i += conditions.is_quick ? stride : 1) indices.push_back(i);
  return indices;
}

}  // namespace dgd_physics
