// iterations: how many iterations the solver takes, class by class of sets, and what its answers are worth. See --help.
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/class_options.h"
#include "bench/exit_status.h"
#include "bench/iteration_count.h"
#include "command_line.h"
#include "program_main.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Counts the iterations of the growth distance over random pairs of sets in random poses, and says
what the answers are worth by their certificates. Everything in double.)";

constexpr const char* kExamples = R"(
Examples:
  iterations                            all classes: some minutes
  iterations --classes curved           one of them
  iterations --pairs 100 --poses 10     a first look: a second
  iterations --classes meshes --meshes DIR
                                        pairs of the hulls of all .obj files in DIR and below
)";

constexpr const char* kFooter =
    R"(Rows:     cold; warm, from the answer at a pose 1 % of the extent and 0.01 rad away, or from its normal
          alone; and without each of what goes beyond the paper. Columns: iterations are evaluations
          of the support functions, percentiles by nearest rank; the worst relative gap and primal
          infeasibility, relative to the pair's size, by dgd/certificate.h; answers that are not
          optimal; and the median time. In each evaluation two virtual calls find the cores, which an
          app does not pay: compare times with each other (the benchmark `speed` knows the types).

Exit status: 0 all answers optimal; 1 some not (at the default tolerance); 2 wrong command line, or a
mesh cannot be read.)";

std::variant<ClassOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  ClassOptions options;
  dgd_demos::CommandLine line("iterations", kDescription, kExamples + ClassesInWords() + kFooter);
  AddClassOptions(line, options);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

void PrintTitles() {
  std::printf("%-40s%10s%8s%6s%6s%8s%6s%10s%10s%13s%10s\n", "", "queries", "mean", "p50", "p99", "p99.99", "max", "gap",
              "primal", "not optimal", "p50 (us)");
}

void Print(const IterationRow& row) {
  const dgd_test::Tally& tally = row.tally;
  std::printf("  %-38s%10lld%8.2f%6d%6d%8d%6d%10.1e%10.1e%13lld%10.3f\n", row.title,
              static_cast<long long>(tally.queries), tally.MeanIterations(), tally.IterationPercentile(0.5),
              tally.IterationPercentile(0.99), tally.IterationPercentile(0.9999), tally.IterationPercentile(1),
              tally.relative_gap.figure, tally.primal_infeasibility.figure, static_cast<long long>(tally.non_optimal),
              row.microseconds_p50);
}

ExitStatus Run(const ClassOptions& options) {
  dgd_test::Random random(options.seed);
  const Meshes meshes = MakeMeshes(options, random);
  std::printf("%d pairs x %d poses a class, seed %llu\n", options.pairs, options.poses,
              static_cast<unsigned long long>(options.seed));
  PrintTitles();
  ExitStatus status = kSuccess;
  for (const PairClass& each : AllPairClasses()) {
    if (!options.Wants(each)) continue;
    const std::vector<IterationRow> rows = CountIterations(each, meshes, options);
    std::printf("%s: %s\n", each.name, each.title);
    for (std::size_t v = 0; v < rows.size(); ++v) {
      Print(rows[v]);
      const bool must_be_optimal = IterationVariants()[v].must_be_optimal;
      if (must_be_optimal && rows[v].tally.non_optimal > 0) status = kFailedQuery;
    }
    std::fflush(stdout);
  }
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
