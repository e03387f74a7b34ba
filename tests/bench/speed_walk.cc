#include "bench/speed_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/class_walk.h"
#include "bench/exact_growth_distance.h"
#include "bench/stopwatch.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {
namespace {

/// Judges beside the pair whose types are known: its sets as numbers, for what asks for no speed.
template <int L>
class ExactPair {
 public:
  explicit ExactPair(const dgd_test::PairNumbers& numbers) : numbers_(numbers), pair_(numbers) {}

  std::optional<double> GrowthDistance(const PairPoses& poses) {
    if constexpr (L == 3) {
      numbers_.pose_1 = poses.pose_1;
      numbers_.pose_2 = poses.pose_2;
      pair_.MoveTo(poses.pose_1, poses.pose_2);
      return ExactGrowthDistance(numbers_, pair_.Center(dgd_test::Which::kFirst),
                                 pair_.Center(dgd_test::Which::kSecond));
    }
    return std::nullopt;
  }

 private:
  dgd_test::PairNumbers numbers_;
  dgd_test::AnyPair<double, L> pair_;
};

/// Of the bound that is farther from it, relative.
double ErrorOf(const SpeedAnswer& answer, double exact) {
  return std::max(std::abs(answer.upper_bound - exact), std::abs(answer.lower_bound - exact)) / exact;
}

template <int L>
void Measure(const SpeedPair<L>& pair, std::span<const SpeedQuestion> questions, const TimedClassOptions& options,
             const std::optional<double>& exact, std::int64_t index, std::vector<MethodFigures>& figures) {
  const std::vector<double> times = LeastOfRounds(options.rounds, questions.size(), [&](std::size_t q) {
    return pair.Takes(questions[q]) ? pair.Time(questions[q], options.repeats) : MethodSample::kNone;
  });
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (!pair.Takes(questions[q])) continue;
    const SpeedAnswer answer = pair.Judge(questions[q]);
    MethodSample sample = SampleOf(answer);
    sample.microseconds = times[q];
    if (exact) sample.exact_error = ErrorOf(answer, *exact);
    figures[q].Take(sample, index);
  }
}

template <int L>
std::vector<MethodFigures> FiguresOf(const PairClass& each, const Meshes& meshes,
                                     std::span<const SpeedQuestion> questions, const TimedClassOptions& options,
                                     int exact_poses) {
  std::vector<MethodFigures> figures(questions.size());
  std::optional<ExactPair<L>> exact;
  WalkClass<L>(
      each, meshes, options,
      [&](const dgd_test::PairNumbers& numbers) {
        if (exact_poses > 0) exact.emplace(numbers);
        return MakeSpeedPair<L>(numbers.set_1, numbers.set_2);
      },
      [&](SpeedPair<L>& pair, const PairPoses& poses, std::int64_t index) {
        pair.MoveTo(poses.pose_1, poses.last_pose_2, poses.pose_2);
        std::optional<double> growth_distance;
        if (index < exact_poses) growth_distance = exact->GrowthDistance(poses);
        Measure(pair, questions, options, growth_distance, index, figures);
      });
  return figures;
}

}  // namespace

MethodSample SampleOf(const SpeedAnswer& answer) {
  return {.iterations = double(answer.iterations),
          .relative_gap = answer.relative_gap,
          .primal_infeasibility = answer.primal_infeasibility,
          .dual_infeasibility = answer.dual_infeasibility,
          .is_failure = answer.is_failure};
}

std::vector<MethodSummary> MeasureClass(const PairClass& each, const Meshes& meshes,
                                        std::span<const SpeedQuestion> questions, const TimedClassOptions& options,
                                        int exact) {
  std::vector<MethodSummary> summaries;
  const auto figures = each.dimension == 2 ? FiguresOf<2>(each, meshes, questions, options, exact)
                                           : FiguresOf<3>(each, meshes, questions, options, exact);
  for (const MethodFigures& method : figures) summaries.push_back(method.Summarize());
  return summaries;
}

}  // namespace dgd_bench
