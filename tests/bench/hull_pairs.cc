// hull_pairs: every method for the contact normal of two hulls, by how far they are apart or how deep. See --help.
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/contest.h"
#include "bench/exit_status.h"
#include "bench/hull_pair.h"
#include "bench/peers/bullet_peers.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times ours, the paper's algorithm as printed and what it compares with, Bullet's GJK/EPA and MPR, and FCL's, which is
libccd's, on the same random pairs of hulls, and judges their answers as narrowphase_replay does.)";

constexpr const char* kFooter = R"(
Examples:
  hull_pairs_float64                        Bullet in double
  hull_pairs_float64 --repeats 1            each query alone, as branch prediction meets it the first time; the
                                            clock's own 0.03 us are in it
  hull_pairs --margin 0.04 --csv raw.csv    one margin; the figures for programs

Pairs:    hulls of 8 to 20 random vertices, 1 m across, in random orientations; the second one is moved
          along a random direction until the exact signed distance of the sets, core + margin, is one drawn
          from the class.
Warm:     from the result at the second hull's last pose, 1 % of its size and 0.01 rad away.
Columns:  those of narrowphase_replay.

Exit status: 0; 1 a wrong answer or none from ours; 2 wrong command line, or the output cannot be written.)";

struct Options {
  int pairs = 2000;
  std::uint64_t seed = 1;
  std::vector<double> margins = {0, 0.04};  // m
  ContestOptions contest{.rounds = 3, .repeats = 20};
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMostPairs = 10'000'000;
  Options options;
  dgd_demos::CommandLine line("hull_pairs", kDescription, kFooter);
  line.AddNumber("--pairs", "N", options.pairs, {1, kMostPairs}, "Pairs of each class and margin");
  line.AddSeed(options.seed, "Seed of the random pairs");
  line.AddNumbers("--margin", "M", options.margins, {0, kHullDiameter / 2}, "Margins in m, some tables each");
  AddContestOptions(line, options.contest);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

PairTurn TurnOf(const HullPair& pair) {
  const auto pose_of = [](const dgd_demos::Pose& pose) { return dgd_test::PoseNumbers{pose.rotation, pose.position}; };
  return {pose_of(pair.pose_1), pose_of(pair.last_pose_2), pose_of(pair.pose_1), pose_of(pair.pose_2)};
}

/// The pairs of a class come from a stream of their own: the same regardless of the other classes and margins.
std::vector<MethodSummary> MeasureClass(const Options& options, const ContestMethods& methods, std::size_t index,
                                        double margin) {
  const DistanceClass& distance_class = kDistanceClasses[index];
  dgd_demos::Random random(options.seed, static_cast<std::uint32_t>(index));
  dgd_demos::ProgressBar progress(distance_class.key, 1);
  ContestFigures figures(methods);
  for (int i = 0; i < options.pairs; ++i) {
    const HullPair pair = DrawHullPair(random, distance_class, DistanceOf::kSets, margin);
    const auto set_of = [margin](const dgd_demos::Polyhedron& core) {
      return dgd_test::SetNumbers{.type = dgd_test::SetType::kPolytope, .points = core.vertices, .radius = margin};
    };
    ContestPair contest(set_of(pair.core_1), set_of(pair.core_2), methods);
    contest.MoveTo(TurnOf(pair));
    figures.Take(contest, contest.Measure(options.contest.rounds, options.contest.repeats), i);
    progress.Update(double(i + 1) / options.pairs);
  }
  return figures.Summarize();
}

ExitStatus Run(const Options& options) {
  const ContestMethods methods = MethodsOf(options.contest);
  std::optional<FiguresCsv> csv;
  if (!options.contest.csv.empty()) csv.emplace(options.contest.csv);
  std::printf("Pairs of hulls, %g m across; %d pairs a class, seed %llu, Bullet in %s; times in us, errors in m\n",
              kHullDiameter, options.pairs, static_cast<unsigned long long>(options.seed), BulletPrecision());
  ExitStatus status = kSuccess;
  for (const double margin : options.margins) {
    for (std::size_t c = 0; c < kDistanceClasses.size(); ++c) {
      const std::vector<MethodSummary> summaries = MeasureClass(options, methods, c, margin);
      std::printf("\n%s, margin %g m\n", kDistanceClasses[c].title, margin);
      PrintContest(methods, summaries);
      std::string work = kDistanceClasses[c].key;
      if (csv) WriteContest(*csv, work.append("_margin_").append(std::to_string(margin)), methods, summaries);
      if (HaveOursFailed(methods, summaries)) status = kFailedQuery;
    }
  }
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
