// speed: time and error of the growth distance, class by class of sets, and of the paper's algorithm as printed. See
// --help.
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/class_options.h"
#include "bench/exit_status.h"
#include "bench/growth_pair.h"
#include "bench/measure_class.h"
#include "command_line.h"
#include "program_main.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times the growth distance on random pairs of sets in random poses, and the paper's algorithm as it is
printed: virtual support functions, margins inside them, coordinates of the world. Both call the same
support functions of the cores, in double, on the same pairs, in turns. Ours is dgd::AnySet's, which the
library holds compiled; in the plane, and for differentiable support functions, the template. All answers
are judged by the same certificate.)";

constexpr const char* kExamples = R"(
Examples:
  speed                             all classes: two minutes
  speed --classes sharp-hulls       one of them
  speed --pairs 20 --poses 5        a first look: a second
  speed --classes meshes --meshes DIR
                                    pairs of the hulls of all .obj files in DIR and below
)";

constexpr const char* kFooter =
    R"(Rows:     cold; warm, from the answer at a pose 1 % of the extent and 0.01 rad away; and the collision
          check, cold; each followed by the plain algorithm's.
Columns:  times over all pairs and poses, each the least of --rounds means of --repeats queries, in us,
          percentiles by nearest rank; the row's p50 over the plain algorithm's; iterations are
          evaluations of the support functions; the worst relative gap, and the worst primal
          infeasibility in m; answers that are not optimal, of checks the wrong or undecided ones.

Exit status: 0 all of our answers optimal and right; 1 some not; 2 wrong command line, or a mesh cannot
be read.)";

std::variant<ClassOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  ClassOptions options;
  dgd_demos::CommandLine line("speed", kDescription, kExamples + ClassesInWords() + kFooter);
  AddClassOptions(line, options);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// The rows of a class: ours, each followed by the paper's algorithm.
constexpr std::array kTitles = {"cold", "  plain", "warm", "  plain", "collision check, cold", "  plain"};
constexpr std::array kQueries = {
    GrowthQuery{},
    GrowthQuery{.algorithm = GrowthAlgorithm::kPlain},
    GrowthQuery{.is_warm = true},
    GrowthQuery{.algorithm = GrowthAlgorithm::kPlain, .is_warm = true},
    GrowthQuery{.is_check = true},
    GrowthQuery{.algorithm = GrowthAlgorithm::kPlain, .is_check = true},
};
static_assert(kTitles.size() == kQueries.size());
constexpr std::size_t kColdRow = 0, kWarmRow = 2, kCheckRow = 4;

using Rows = std::vector<MethodSummary>;

void Print(const PairClass& each, const Rows& rows) {
  std::printf("%s: %s\n", each.name, each.title);
  for (std::size_t m = 0; m < rows.size(); ++m) {
    const MethodSummary& row = rows[m];
    std::printf("  %-24s%9.3f%9.3f%9.3f", kTitles[m], row.p50, row.p99, row.p9999);
    if (kQueries[m].algorithm == GrowthAlgorithm::kPlain) {
      std::printf("%10s", "");
    } else {
      std::printf("%10.2f", row.p50 / rows[m + 1].p50);
    }
    if (kQueries[m].is_check) {
      std::printf("%8s%10s%10s", "", "", "");
    } else {
      std::printf("%8.2f%10.1e%10.1e", row.iterations, row.Of(ErrorKind::kGap).most, row.Of(ErrorKind::kPrimal).most);
    }
    std::printf("%10lld\n", static_cast<long long>(row.failures));
  }
  std::fflush(stdout);
}

/// Time against vertex count, of the classes that differ in nothing else: the exponents from the first to the last.
void PrintGrowth(const std::vector<std::pair<const PairClass*, Rows>>& measured) {
  if (measured.size() < 2) return;
  const PairClass &first = *measured.front().first, &last = *measured.back().first;
  const auto growth = [&](std::size_t row) {
    return std::log(measured.back().second[row].p50 / measured.front().second[row].p50) /
           std::log(double(last.vertices) / first.vertices);
  };
  std::printf("From %d to %d vertices, times grow as n to the power of: cold %.2f, warm %.2f, collision check %.2f; ",
              first.vertices, last.vertices, growth(kColdRow), growth(kWarmRow), growth(kCheckRow));
  std::printf("plain %.2f, %.2f, %.2f\n", growth(kColdRow + 1), growth(kWarmRow + 1), growth(kCheckRow + 1));
}

ExitStatus Run(const ClassOptions& options) {
  dgd_test::Random random(options.seed);
  const Meshes meshes = MakeMeshes(options, random);
  std::printf("%d pairs x %d poses a class, seed %llu; times in us\n", options.pairs, options.poses,
              static_cast<unsigned long long>(options.seed));
  std::printf("%-26s%9s%9s%9s%10s%8s%10s%10s%10s\n", "", "p50", "p99", "p99.99", "to plain", "iter.", "gap", "primal",
              "failures");
  ExitStatus status = kSuccess;
  std::vector<std::pair<const PairClass*, Rows>> by_vertices;
  for (const PairClass& each : AllPairClasses()) {
    if (!options.Wants(each)) continue;
    const Rows rows = MeasureClass(each, meshes, kQueries, options, MakeGrowthPair);
    Print(each, rows);
    if (each.vertices > 0) by_vertices.emplace_back(&each, rows);
    for (std::size_t m = 0; m < rows.size(); m += 2) {
      if (rows[m].failures > 0) status = kFailedQuery;
    }
  }
  PrintGrowth(by_vertices);
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
