#include "bench/measure_class.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/stopwatch.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

/// Of the bound that is farther from it, relative.
double ErrorOf(const GrowthAnswer& answer, double exact) {
  return std::max(std::abs(answer.upper_bound - exact), std::abs(answer.lower_bound - exact)) / exact;
}

}  // namespace

void ForEachPose(const PairClass& each, const Meshes& meshes, const ClassOptions& options, MakePair make,
                 const std::function<void(const GrowthPair& pair, std::int64_t index)>& visit) {
  dgd_demos::ProgressBar progress(each.name, 1);
  dgd_test::Random random(options.seed);
  const int pairs = std::max(1, options.pairs / each.poses_factor);
  const int poses = options.pairs * options.poses / pairs;
  std::int64_t index = 0;
  for (int i = 0; i < pairs; ++i) {
    const dgd_test::PairNumbers sets = each.draw_sets(random, meshes);
    const std::unique_ptr<GrowthPair> pair = make(sets.set_1, sets.set_2);
    for (int j = 0; j < poses; ++j) {
      pair->MoveTo(DrawPoses(random, each.dimension, pair->Extent()));
      visit(*pair, index++);
    }
    progress.Update(static_cast<double>(i + 1) / pairs);
  }
}

std::vector<MethodSummary> MeasureClass(const PairClass& each, const Meshes& meshes,
                                        std::span<const GrowthQuery> queries, const ClassOptions& options,
                                        MakePair make, int exact_poses) {
  std::vector<MethodFigures> figures(queries.size());
  ForEachPose(each, meshes, options, make, [&](const GrowthPair& pair, std::int64_t index) {
    const std::vector<double> times = LeastOfRounds(options.rounds, queries.size(), [&](std::size_t q) {
      return pair.Takes(queries[q]) ? pair.Time(queries[q], options.repeats) : MethodSample::kNone;
    });
    std::optional<double> exact;
    if (index < exact_poses) exact = pair.ExactGrowthDistance();
    for (std::size_t q = 0; q < queries.size(); ++q) {
      if (!pair.Takes(queries[q])) continue;
      GrowthAnswer answer = pair.Solve(queries[q]);
      answer.sample.microseconds = times[q];
      if (exact) answer.sample.exact_error = ErrorOf(answer, *exact);
      figures[q].Take(answer.sample, index);
    }
  });
  std::vector<MethodSummary> summaries;
  for (const MethodFigures& method : figures) summaries.push_back(method.Summarize());
  return summaries;
}

}  // namespace dgd_bench
