// shape_pairs: every method for the contact normal of two shapes, by how far they are apart or how deep. See --help.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/contest.h"
#include "bench/exit_status.h"
#include "bench/peers/bullet_peers.h"
#include "bench/shape_pair.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times ours, the paper's algorithm as printed and what it compares with, Bullet's GJK/EPA and MPR, and FCL's, which is
libccd's, on the same random pairs of shapes, and judges their answers as narrowphase_replay does.)";

constexpr const char* kFooter = R"(
Examples:
  shape_pairs_float64                       Bullet in double
  shape_pairs --kinds hulls,boxes --margin 0.04 --csv raw.csv
                                            some kinds, with one margin; the figures for programs
  shape_pairs --kinds cones --repeats 1 --details
                                            all figures; each query alone, as branch prediction meets it the
                                            first time, with the clock's own 0.03 us

Kinds:    hulls of 8 to 20 random vertices, 1 m across; boxes of half lengths 0.1 to 0.5 m; capsules of radius
          0.1 to 0.25 m and half length 0.1 to 0.4 m; cylinders of radius and half height 0.15 to 0.4 m; cones
          of base radius 0.2 to 0.5 m and height 0.3 to 0.9 m; ellipsoids of semi-axes 0.15 to 0.5 m.
Margins:  added to both shapes of hulls, boxes, cylinders and cylinder-hull; the other kinds are measured once,
          without a margin.
Pairs:    in random orientations; the second shape is moved along a random direction until the signed distance
          of the sets, core + margin, is one drawn from the class, to 1e-9 m.
Classes:  separated by 2 to 30 cm; nearly touching, 0.1 to 10 mm apart; touching, within 1 um; shallow, 0.1 to
          10 mm deep; deep, 5 to 15 cm.
Warm:     from the result at the second shape's last pose, 1 % of its size and 0.01 rad away.
Rows:     the methods that take such shapes; "ours" alone is the growth distance, which is another problem and
          has no error of the normal.
Columns:  for each class p50 / p99 of a query's time in us and the worst error of the normal in m; then the pairs
          of all classes with a wrong yes or no, and those without an answer. --details: a table a class, with
          the columns of narrowphase_replay.

Exit status: 0; 1 a wrong answer or none from ours; 2 wrong command line, or the output cannot be written.)";

struct Options {
  std::vector<std::string> kinds = {};  // Empty for all.
  int pairs = 2000;
  std::uint64_t seed = 1;
  std::vector<double> margins = {0, 0.04};  // m
  bool with_details = false;
  ContestOptions contest{.methods = {"bullet_gjk_epa", "fcl", "signed_distance", "signed_distance_warm", "growth"},
                         .rounds = 3,
                         .repeats = 20};
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMostPairs = 10'000'000;
  Options options;
  std::vector<std::string> keys;
  std::string all_keys;
  for (const ShapeKind& kind : kShapeKinds) {
    if (!keys.empty()) all_keys += ", ";
    all_keys += keys.emplace_back(kind.key);
  }
  dgd_demos::CommandLine line("shape_pairs", kDescription, kFooter);
  line.AddChoices("--kinds", "A,B", options.kinds, keys, "Some of the kinds: " + all_keys);
  line.AddNumber("--pairs", "N", options.pairs, {1, kMostPairs}, "Pairs of each kind, class and margin");
  line.AddSeed(options.seed, "Seed of the random pairs");
  line.AddNumbers("--margin", "M", options.margins, {0, kShapeSize / 2}, "Margins in m, a table each");
  line.AddFlag("--details", options.with_details, "Print a table of all figures for each class as well");
  AddContestOptions(line, options.contest);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

PairTurn TurnOf(const ShapePair& pair) {
  return {pair.sets.pose_1, pair.last_pose_2, pair.sets.pose_1, pair.sets.pose_2};
}

using ClassSummaries = std::array<std::vector<MethodSummary>, kDistanceClasses.size()>;

/// Pairs of one kind with one margin.
class ShapePairs {
 public:
  ShapePairs(const Options& options, const ContestMethods& methods, std::size_t kind, double margin)
      : options_(options), methods_(methods), kind_(kind), margin_(margin) {}

  /// Draws the pairs of all classes, and times every method on them.
  void Measure() {
    for (std::size_t c = 0; c < kDistanceClasses.size(); ++c) summaries_[c] = MeasureClass(c);
  }

  void PrintDetails() const {
    for (std::size_t c = 0; c < kDistanceClasses.size(); ++c) {
      std::printf("\n%s, margin %g m: %s\n", Kind().key, margin_, kDistanceClasses[c].title);
      PrintContest(methods_, summaries_[c]);
    }
  }

  /// The methods that take such shapes.
  void PrintByClass() const {
    std::printf("\n%s, margin %g m: p50 / p99 (us) and worst error of the normal (m)\n%-30s", Kind().key, margin_, "");
    for (const DistanceClass& distance_class : kDistanceClasses) std::printf("%25s", distance_class.key);
    std::printf("%7s%9s\n", "wrong", "missing");
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (summaries_.front()[m].pairs > 0) PrintMethod(m);
    }
  }

  void Write(FiguresCsv& csv) const {
    for (std::size_t c = 0; c < kDistanceClasses.size(); ++c) {
      char margin[32];
      std::snprintf(margin, sizeof margin, "%g", margin_);
      const std::string work = std::string(Kind().key) + '_' + kDistanceClasses[c].key + '_' + margin;
      WriteContest(csv, work, methods_, summaries_[c]);
    }
  }

  bool HaveOursFailed() const {
    return std::ranges::any_of(summaries_, [this](const std::vector<MethodSummary>& summaries) {
      return dgd_bench::HaveOursFailed(methods_, summaries);
    });
  }

 private:
  const ShapeKind& Kind() const { return kShapeKinds[kind_]; }

  /// The pairs come from a stream of their own: the same regardless of the other kinds, classes and margins.
  std::vector<MethodSummary> MeasureClass(std::size_t index) const {
    const DistanceClass& distance_class = kDistanceClasses[index];
    dgd_demos::Random random(options_.seed, static_cast<std::uint32_t>(kind_ * kDistanceClasses.size() + index));
    dgd_demos::ProgressBar progress(std::string(Kind().key) + ' ' + distance_class.key, 1);
    ContestFigures figures(methods_);
    for (int i = 0; i < options_.pairs; ++i) {
      const ShapePair pair = DrawShapePair(random, Kind(), distance_class, margin_);
      ContestPair contest(pair.sets.set_1, pair.sets.set_2, methods_);
      contest.MoveTo(TurnOf(pair));
      figures.Take(contest, contest.Measure(options_.contest.rounds, options_.contest.repeats), i);
      progress.Update(double(i + 1) / options_.pairs);
    }
    return figures.Summarize();
  }

  void PrintMethod(std::size_t method) const {
    std::printf("%-30s", methods_[method]->title.c_str());
    std::int64_t wrong = 0, missing = 0;
    for (const std::vector<MethodSummary>& summaries : summaries_) {
      const MethodSummary& summary = summaries[method];
      std::printf("%7.2f /%7.2f", summary.p50, summary.p99);
      PrintNumber("%9.1e", 9, summary.Of(ErrorKind::kNormal).most);
      wrong += summary.wrong;
      missing += summary.missing;
    }
    std::printf("%7lld%9lld\n", static_cast<long long>(wrong), static_cast<long long>(missing));
  }

  const Options& options_;
  const ContestMethods& methods_;
  std::size_t kind_;
  double margin_;  // m
  ClassSummaries summaries_;
};

ExitStatus Run(const Options& options) {
  const ContestMethods methods = MethodsOf(options.contest);
  std::optional<FiguresCsv> csv;
  if (!options.contest.csv.empty()) csv.emplace(options.contest.csv);
  std::printf(
      "Pairs of shapes about %g m across; %d pairs a class, seed %llu, Bullet in %s; times in us, errors in m\n",
      kShapeSize, options.pairs, static_cast<unsigned long long>(options.seed), BulletPrecision());
  ExitStatus status = kSuccess;
  for (std::size_t kind = 0; kind < kShapeKinds.size(); ++kind) {
    const ShapeKind& shapes = kShapeKinds[kind];
    if (!options.kinds.empty() && std::ranges::count(options.kinds, shapes.key) == 0) continue;
    const std::vector<double> margins = shapes.takes_margin ? options.margins : std::vector<double>{0};
    for (const double margin : margins) {
      ShapePairs pairs(options, methods, kind, margin);
      pairs.Measure();
      if (options.with_details) pairs.PrintDetails();
      pairs.PrintByClass();
      if (csv) pairs.Write(*csv);
      if (pairs.HaveOursFailed()) status = kFailedQuery;
    }
  }
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
