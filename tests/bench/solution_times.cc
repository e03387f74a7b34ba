// solution_times: time and error of every algorithm for the growth distance on the paper's kinds of pairs. See --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/class_options.h"
#include "bench/exit_status.h"
#include "bench/growth_methods.h"
#include "bench/measure_class.h"
#include "bench/method_figures.h"
#include "bench/percentile.h"
#include "bench/textbook/comparators.h"
#include "command_line.h"
#include "program_main.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times all ways to a growth distance that the paper compares (its Sec. VI), on the same random pairs in turns:
ours, the paper's algorithm as printed, and IE, Inc, DCF and DCol, written from their papers with the same
support functions. Each answer is judged by the same certificate.)";

constexpr const char* kExamples = R"(
Examples:
  solution_times                                    all classes, each method's own tolerance
  solution_times --tolerances --classes curved,dsf  time against achieved error
  solution_times --convergence --classes curved     gap against iteration, an evaluation of both support functions:
                                                    median and 99 % of cold queries to a gap of 1e-12
  solution_times --pairs 20 --poses 5               a first look
)";

constexpr const char* kFooter =
    R"(Rows:     the methods; "unsupported" where one has no answer for any pair of the class. Warm is from the answer
          at a pose 1 % of the extent and 0.01 rad away.
Columns:  pairs that the method takes; times of a query in us, each the least of --rounds means of --repeats,
          percentiles by nearest rank; mean iterations, which are evaluations of the support functions, or the
          method's own steps (Inc, DCol); relative gap and primal infeasibility in m, median and worst; how far the
          bounds are from the exact growth distance where a linear program in extended precision tells it (of sharp
          polytopes; itself within 1e-13), relative, the worst of the first 300 poses; answers that the method
          itself calls not optimal.

Exit status: 0 all of our answers optimal; 1 some not; 2 wrong command line, or a mesh cannot be read.)";

/// Poses of each class in which answers are compared with the exact one: as many as --help says.
constexpr int kExactPoses = 300;

struct Options : ClassOptions {
  Options() { repeats = 5; }

  bool tolerances = false, convergence = false;
  std::filesystem::path csv;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  Options options;
  dgd_demos::CommandLine line("solution_times", kDescription, kExamples + ClassesInWords() + kFooter);
  AddClassOptions(line, options);
  line.AddFlag("--tolerances", options.tolerances, "Ask for relative gaps of 1e-3 to 1e-12 as well, cold");
  line.AddFlag("--convergence", options.convergence,
               "Print instead, as CSV, the relative gap after each iteration of ours and of the paper's algorithm");
  line.AddPath("--csv", "FILE", options.csv, "Write the figures to this file");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

std::vector<GrowthMethod> MethodsOf(const Options& options) {
  std::vector<GrowthMethod> methods;
  for (const GrowthMethod& method : kGrowthMethods) {
    methods.push_back(method);
    if (!options.tolerances || !HasTolerance(method.query)) continue;
    for (const double tolerance : kTolerances) {
      methods.push_back(method);
      methods.back().query.tolerance = tolerance;
    }
  }
  return methods;
}

void Print(const PairClass& each, const std::vector<GrowthMethod>& methods,
           const std::vector<MethodSummary>& summaries) {
  std::printf("%s: %s\n", each.name, each.title);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::string title = methods[m].title;
    if (methods[m].query.tolerance > 0) {
      std::array<char, 32> tolerance;
      std::snprintf(tolerance.data(), tolerance.size(), ", gap %.0e", methods[m].query.tolerance);
      title += tolerance.data();
    }
    const MethodSummary& summary = summaries[m];
    std::printf("  %-36s", title.c_str());
    if (summary.pairs == 0) {
      std::printf("unsupported\n");
      continue;
    }
    const ErrorFigure &gap = summary.Of(ErrorKind::kGap), &primal = summary.Of(ErrorKind::kPrimal);
    std::printf("%8zu%9.3f%9.3f%9.3f%9.3f%9.3f%9.2f%10.1e%10.1e%10.1e%10.1e", summary.pairs, summary.p25, summary.p50,
                summary.p75, summary.p99, summary.p9999, summary.iterations, gap.p50, gap.most, primal.p50,
                primal.most);
    const double exact = summary.Of(ErrorKind::kExact).most;
    if (std::isnan(exact)) {
      std::printf("%10s", "");
    } else {
      std::printf("%10.1e", exact);
    }
    std::printf("%10lld\n", static_cast<long long>(summary.failures));
  }
  std::fflush(stdout);
}

bool MustBeOptimal(const GrowthQuery& query) {
  return query.algorithm == GrowthAlgorithm::kOurs && query.tolerance == 0;
}

/// Every query is stopped after 1, 2, ... iterations; those that have ended stay at the gap that they ended with.
void PrintConvergence(const PairClass& each, const Meshes& meshes, const Options& options) {
  constexpr std::size_t kIterations = 60;
  constexpr double kLeastGap = 1e-17;  // What is 0 on a logarithmic axis.
  constexpr std::array kAlgorithms = {GrowthAlgorithm::kOurs, GrowthAlgorithm::kPlain};
  constexpr std::array kKeys = {"growth", "plain"};
  std::array<std::array<std::vector<double>, kIterations>, kAlgorithms.size()> gaps;
  ForEachPose(each, meshes, options, MakeGrowthPair, [&](const GrowthPair& pair, std::int64_t) {
    for (std::size_t a = 0; a < kAlgorithms.size(); ++a) {
      for (std::size_t i = 0; i < kIterations; ++i) {
        const GrowthAnswer answer =
            pair.Solve({.algorithm = kAlgorithms[a], .tolerance = 1e-12, .max_iterations = static_cast<int>(i) + 1});
        gaps[a][i].push_back(std::max(answer.upper_bound / answer.lower_bound - 1, kLeastGap));
      }
    }
  });
  for (std::size_t a = 0; a < kAlgorithms.size(); ++a) {
    for (std::size_t i = 0; i < kIterations; ++i) {
      std::ranges::sort(gaps[a][i]);
      std::printf("%s,%s,%zu,%.6g,%.6g\n", each.name, kKeys[a], i + 1, Percentile(gaps[a][i], 0.5),
                  Percentile(gaps[a][i], 0.99));
    }
  }
  std::fflush(stdout);
}

ExitStatus Run(const Options& options) {
  dgd_test::Random random(options.seed);
  const Meshes meshes = MakeMeshes(options, random);
  if (options.convergence) {
    std::printf("class,method,iteration,gap_p50,gap_p99\n");
    for (const PairClass& each : AllPairClasses()) {
      if (options.Wants(each)) PrintConvergence(each, meshes, options);
    }
    return kSuccess;
  }
  const std::vector<GrowthMethod> methods = MethodsOf(options);
  std::vector<GrowthQuery> queries;
  for (const GrowthMethod& method : methods) queries.push_back(method.query);
  std::optional<FiguresCsv> csv;
  if (!options.csv.empty()) csv.emplace(options.csv);
  std::printf("%d pairs x %d poses a class, seed %llu; times in us\n", options.pairs, options.poses,
              static_cast<unsigned long long>(options.seed));
  std::printf("%-38s%8s%9s%9s%9s%9s%9s%9s%10s%10s%10s%10s%10s%10s\n", "", "pairs", "p25", "p50", "p75", "p99", "p99.99",
              "iter.", "gap p50", "gap max", "prim. p50", "prim. max", "exact", "failures");
  ExitStatus status = kSuccess;
  for (const PairClass& each : AllPairClasses()) {
    if (!options.Wants(each)) continue;
    const std::vector<MethodSummary> summaries =
        MeasureClass(each, meshes, queries, options, MakeComparedPair, kExactPoses);
    Print(each, methods, summaries);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const GrowthQuery& query = queries[m];
      if (csv) {
        csv->Write({each.name, methods[m].key, methods[m].title, query.is_warm, query.tolerance, each.vertices},
                   summaries[m]);
      }
      if (MustBeOptimal(query) && summaries[m].failures > 0) status = kFailedQuery;
    }
  }
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
