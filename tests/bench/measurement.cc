#include "bench/measurement.h"

#include <algorithm>
#include <cmath>

#include "bench/percentile.h"
#include "bench/stopwatch.h"

namespace dgd_bench {
namespace {

using Figure = double (*)(const Sample&);

// The figure of every pair that has it, in ascending order.
std::vector<double> Sorted(const Block& block, std::size_t method, Figure figure) {
  std::vector<double> figures;
  for (const PairRow& row : block.rows) {
    const double value = figure(row.samples[method]);
    if (!std::isnan(value)) figures.push_back(value);
  }
  std::ranges::sort(figures);
  return figures;
}

double Largest(const std::vector<double>& sorted) { return Percentile(sorted, 1); }

double Sum(const std::vector<double>& figures) {
  double sum = 0;
  for (const double figure : figures) sum += figure;
  return sum;
}

}  // namespace

PairRow Measure(const HullPair& pair, const TimingEffort& effort) {
  std::array<std::unique_ptr<Query>, kMethods.size()> queries;
  for (std::size_t m = 0; m < kMethods.size(); ++m) queries[m] = kMethods[m].make_query(pair);

  PairRow row;
  row.signed_distance = pair.signed_distance;
  const std::vector<double> times =
      LeastOfRounds(effort.rounds, kMethods.size(), [&](std::size_t m) { return queries[m]->Time(effort.repeats); });
  for (std::size_t m = 0; m < kMethods.size(); ++m) row.samples[m] = {times[m], queries[m]->Judge(pair)};
  return row;
}

Summary Summarize(const Block& block, std::size_t method) {
  const auto sorted = [&](Figure figure) { return Sorted(block, method, figure); };
  const auto times = sorted([](const Sample& sample) { return sample.microseconds; });
  const auto iterations = sorted([](const Sample& sample) { return sample.judgement.iterations; });
  const auto errors = sorted([](const Sample& sample) { return sample.judgement.normal_error; });
  const auto gaps = sorted([](const Sample& sample) { return sample.judgement.relative_gap; });
  const auto infeasibilities = sorted([](const Sample& sample) { return sample.judgement.primal_infeasibility; });
  const auto missing = sorted([](const Sample& sample) { return sample.judgement.is_missing ? 1.0 : 0.0; });
  const auto failures = sorted([](const Sample& sample) { return sample.judgement.is_failure ? 1.0 : 0.0; });
  return {.p50 = Percentile(times, 0.5),
          .p99 = Percentile(times, 0.99),
          .p9999 = Percentile(times, 0.9999),
          .slowest = Largest(times),
          .mean_iterations = Sum(iterations) / static_cast<double>(iterations.size()),
          .normal_error_p99 = Percentile(errors, 0.99),
          .normal_error_max = Largest(errors),
          .relative_gap_max = Largest(gaps),
          .primal_infeasibility_max = Largest(infeasibilities),
          .missing = Sum(missing),
          .failures = Sum(failures)};
}

}  // namespace dgd_bench
