#include "bench/speed_walk.h"

#include "bench/class_walk.h"
#include "bench/stopwatch.h"

namespace dgd_bench {
namespace {

template <int L>
void Measure(const SpeedPair<L>& pair, std::span<const SpeedQuestion> questions, const TimedClassOptions& options,
             std::int64_t index, std::vector<MethodFigures>& figures) {
  const std::vector<double> times = LeastOfRounds(options.rounds, questions.size(), [&](std::size_t q) {
    return pair.Takes(questions[q]) ? pair.Time(questions[q], options.repeats) : MethodSample::kNone;
  });
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (!pair.Takes(questions[q])) continue;
    MethodSample sample = SampleOf(pair.Judge(questions[q]));
    sample.microseconds = times[q];
    figures[q].Take(sample, index);
  }
}

template <int L>
std::vector<MethodFigures> FiguresOf(const PairClass& each, const Meshes& meshes,
                                     std::span<const SpeedQuestion> questions, const TimedClassOptions& options) {
  std::vector<MethodFigures> figures(questions.size());
  WalkClass<L>(
      each, meshes, options,
      [](const dgd_test::PairNumbers& numbers) { return MakeSpeedPair<L>(numbers.set_1, numbers.set_2); },
      [&](SpeedPair<L>& pair, const PairPoses& poses, std::int64_t index) {
        pair.MoveTo(poses.pose_1, poses.last_pose_2, poses.pose_2);
        Measure(pair, questions, options, index, figures);
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
                                        std::span<const SpeedQuestion> questions, const TimedClassOptions& options) {
  std::vector<MethodSummary> summaries;
  const auto figures = each.dimension == 2 ? FiguresOf<2>(each, meshes, questions, options)
                                           : FiguresOf<3>(each, meshes, questions, options);
  for (const MethodFigures& method : figures) summaries.push_back(method.Summarize());
  return summaries;
}

}  // namespace dgd_bench
