#include "bench/bench_options.h"

#include <map>
#include <optional>
#include <string>

#include "command_line.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times the growth distance against Bullet's GJK/EPA, FCL's, which is libccd's, and the paper's algorithm
as printed, on the same random pairs of hulls, and says what the answers are worth. hull_pairs runs Bullet in float, hull_pairs_float64 in double.)";

constexpr const char* kFooter = R"(
Examples:
  hull_pairs_float64                        the table of the README: a few seconds a margin
  hull_pairs_float64 --pairs 100000         for p99.99: below 10000 pairs it is the maximum
  hull_pairs_float64 --repeats 1            each query alone: what branch prediction does not know yet;
                                            the clock's own 0.03 us are in it
  hull_pairs --margin 0.04 --csv raw.csv    one margin; every pair's figures for programs

Pairs:    hulls of 8 to 20 random vertices, 1 m across, in random orientations; the second one is moved
          along a random direction until the exact signed distance is one drawn from the class. With
          margins it is that of the sets, core + margin; --distance-of cores takes that of the bare
          cores instead, where Bullet changes from GJK to EPA.
Time:     the mean over repeats in a row; all methods in turn, pair by pair, for some rounds; the least
          round counts. Shapes are built outside of it. Bullet makes its simplex solver and detector
          anew each time, as it does in a simulation; its maximum distance is unlimited, and so is ours.
Warm:     from the result at the second hull's last pose, 1 % of its size and 0.01 rad away.

Exit status: 0 all went well; 1 a growth distance in double was not optimal or a yes/no was wrong;
2 wrong command line, or the output cannot be written.)";

constexpr int kMaxPairs = 10'000'000;
constexpr int kMaxEffort = 1'000'000;
// m. Rounder than that, they are hulls no more.
constexpr double kMaxMargin = kHullDiameter / 2;

const std::map<std::string, DistanceOf> kDistanceNames = {{"sets", DistanceOf::kSets}, {"cores", DistanceOf::kCores}};

}  // namespace

const char* NameOf(DistanceOf distance_of) { return distance_of == DistanceOf::kSets ? "sets" : "cores"; }

std::variant<BenchOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  BenchOptions options;
  std::string distance_of = NameOf(options.distance_of);

  dgd_demos::CommandLine line("hull_pairs", kDescription, kFooter);
  line.AddNumber("--pairs", "N", options.pairs, {1, kMaxPairs}, "Pairs of each class and margin");
  line.AddSeed(options.seed, "Seed of the random pairs");
  line.AddNumbers("--margin", "M", options.margins, {0, kMaxMargin}, "Margins in m, one table each");
  line.AddChoice("--distance-of", "WHAT", distance_of, {"sets", "cores"},
                 "What lies apart as the class says: sets or cores");
  line.AddNumber("--repeats", "N", options.effort.repeats, {1, kMaxEffort}, "Queries in a row that are averaged");
  line.AddNumber("--rounds", "N", options.effort.rounds, {1, kMaxEffort}, "Rounds of which the least counts");
  line.AddPath("--csv", "FILE", options.csv, "File for one row per pair and method");

  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  options.distance_of = kDistanceNames.at(distance_of);
  return options;
}

}  // namespace dgd_bench
