// convergence: the relative gap of the bounds after each iteration, over random pairs. See --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/class_walk.h"
#include "bench/exit_status.h"
#include "bench/percentile.h"
#include "command_line.h"
#include "program_main.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(How fast the bounds on the growth distance approach each other: upper / lower - 1 after each iteration of cold
queries to a gap of 1e-12, over random pairs. As CSV, on standard output.)";

constexpr const char* kFooter = R"(
Columns:  class; variant (ours, or without what goes beyond the paper); iteration, an evaluation of both support
          functions; median and 99 % of the gap, queries that have ended with the gap they ended with.

Exit status: 0; 2 wrong command line, or a mesh cannot be read.)";

constexpr int kIterations = 60;
/// What is 0 on a logarithmic axis.
constexpr double kLeastGap = 1e-17;

std::variant<ClassOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  ClassOptions options;
  options.pairs = 100;
  options.poses = 20;
  options.classes = {"curved", "meshes"};
  dgd_demos::CommandLine line("convergence", kDescription, ClassesInWords() + kFooter);
  AddClassOptions(line, options);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

struct Variant {
  const char* key;
  dgd::Settings<double> settings;
};

constexpr std::array kVariants = [] {
  Variant ours{"ours", {}}, first_order{"ours, no second-order steps", {}}, printed{"the paper's steps alone", {}};
  first_order.settings.second_order = false;
  printed.settings.second_order = printed.settings.rounding = false;
  printed.settings.known_points = printed.settings.half_way_cuts = printed.settings.likely_start = false;
  std::array variants{ours, first_order, printed};
  for (Variant& variant : variants) variant.settings.relative_tolerance = 1e-12;
  return variants;
}();

/// Of one variant: after each iteration, the gaps of all queries.
using Gaps = std::array<std::vector<double>, kIterations>;

template <int L>
void Observe(const dgd_test::AnyPair<double, L>& pair, const Variant& variant, Gaps& gaps) {
  std::array<double, kIterations> after;
  after.fill(std::numeric_limits<double>::quiet_NaN());
  pair.GrowthDistance(variant.settings, nullptr, [&](const dgd::Iterate<double, L>& iterate) {
    if (iterate.iteration > kIterations) return;
    const double gap = iterate.upper_bound / iterate.lower_bound - 1;
    after[static_cast<std::size_t>(iterate.iteration - 1)] = std::max(gap, kLeastGap);
  });
  double last = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!std::isnan(after[i])) last = after[i];
    gaps[i].push_back(last);
  }
}

template <int L>
std::array<Gaps, kVariants.size()> ObserveClass(const PairClass& each, const Meshes& meshes,
                                                const ClassOptions& options) {
  std::array<Gaps, kVariants.size()> gaps;
  WalkClass<L>(
      each, meshes, options,
      [](const dgd_test::PairNumbers& numbers) { return std::make_unique<dgd_test::AnyPair<double, L>>(numbers); },
      [&](dgd_test::AnyPair<double, L>& pair, const PairPoses& poses, std::int64_t) {
        pair.MoveTo(poses.pose_1, poses.pose_2);
        for (std::size_t v = 0; v < kVariants.size(); ++v) Observe(pair, kVariants[v], gaps[v]);
      });
  return gaps;
}

void Print(const PairClass& each, std::array<Gaps, kVariants.size()> gaps) {
  for (std::size_t v = 0; v < kVariants.size(); ++v) {
    for (std::size_t i = 0; i < kIterations; ++i) {
      std::vector<double>& after = gaps[v][i];
      std::ranges::sort(after);
      std::printf("%s,\"%s\",%zu,%.6g,%.6g\n", each.name, kVariants[v].key, i + 1, Percentile(after, 0.5),
                  Percentile(after, 0.99));
    }
  }
  std::fflush(stdout);
}

ExitStatus Run(const ClassOptions& options) {
  dgd_test::Random random(options.seed);
  const Meshes meshes = MakeMeshes(options, random);
  std::printf("class,variant,iteration,gap_p50,gap_p99\n");
  for (const PairClass& each : AllPairClasses()) {
    if (!options.Wants(each)) continue;
    Print(each, each.dimension == 2 ? ObserveClass<2>(each, meshes, options) : ObserveClass<3>(each, meshes, options));
  }
  return kSuccess;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
