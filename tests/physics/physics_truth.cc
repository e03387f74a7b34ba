// physics_truth: experiments with known results, on Bullet's built-in narrowphase and on the plugin. See --help.
#include <LinearMath/btScalar.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/comparison.h"
#include "physics/truth_options.h"
#include "program_main.h"

namespace dgd_physics {
namespace {

constexpr const char* kPrecision = sizeof(btScalar) == sizeof(double) ? "double" : "float";

bool Wants(const TruthOptions& options, const Experiment& experiment) {
  return options.classes.empty() || std::ranges::count(options.classes, experiment.name) > 0;
}

/// The rows of a class: all cases, then each group; a comparison a rate.
std::vector<std::vector<Comparison>> Rows(const TruthOptions& options, const Experiment& experiment) {
  std::vector<std::vector<Comparison>> rows;
  for (const double rate : options.rates) {
    const std::vector<Comparison> column = WithGroups(
        Compare(experiment, {.rate = rate, .is_quick = options.is_quick, .in_compounds = options.in_compounds}));
    rows.resize(column.size());
    for (std::size_t i = 0; i < column.size(); ++i) rows[i].push_back(column[i]);
  }
  return rows;
}

void WriteCsv(const std::filesystem::path& file, const std::vector<Comparison>& comparisons) {
  std::ofstream stream(file);
  stream << FormatCsv(comparisons, kPrecision) << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

ExitStatus Run(const TruthOptions& options) {
  std::printf("Bullet in %s; root mean square of relative errors against theory%s\n", kPrecision,
              options.is_quick ? ", some cases only" : "");
  if (options.in_compounds) std::printf("Each convex body's shape is the only child of a compound.\n");
  std::printf("%s", FormatHeading(options.rates).c_str());
  std::vector<Comparison> all, judged;
  for (const Experiment& experiment : Experiments()) {
    if (!Wants(options, experiment)) continue;
    for (const std::vector<Comparison>& row : Rows(options, experiment)) {
      std::printf("%s", FormatRow(row).c_str());
      judged.insert(judged.end(), row.begin(), row.end());
      if (!row.front().group.empty()) continue;
      all.insert(all.end(), row.begin(), row.end());
      if (!options.lists_cases) continue;
      for (const Comparison& comparison : row) std::printf("%s", FormatCases(comparison).c_str());
    }
    std::fflush(stdout);
  }
  if (!options.csv.empty()) WriteCsv(options.csv, all);
  const std::string failures = FormatFailures(judged);
  std::printf("%s", failures.c_str());
  return failures.empty() ? kSuccess : kFailedVerdict;
}

}  // namespace
}  // namespace dgd_physics

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_physics::ParseCommandLine(argc, argv), dgd_physics::Run);
}
