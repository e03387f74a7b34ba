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

void WriteCsv(const std::filesystem::path& file, const std::vector<Comparison>& comparisons) {
  std::ofstream stream(file);
  stream << FormatCsv(comparisons, kPrecision) << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

ExitStatus Run(const TruthOptions& options) {
  std::printf("Bullet in %s; root mean square of relative errors against theory%s\n", kPrecision,
              options.is_quick ? ", some cases only" : "");
  std::printf("%s", FormatHeading(options.rates).c_str());
  std::vector<Comparison> all;
  for (const Experiment& experiment : Experiments()) {
    if (!Wants(options, experiment)) continue;
    std::vector<Comparison> row;
    for (const double rate : options.rates) row.push_back(Compare(experiment, rate, options.is_quick));
    std::printf("%s", FormatRow(row).c_str());
    if (options.lists_cases) {
      for (const Comparison& comparison : row) std::printf("%s", FormatCases(comparison).c_str());
    }
    std::fflush(stdout);
    all.insert(all.end(), row.begin(), row.end());
  }
  if (!options.csv.empty()) WriteCsv(options.csv, all);
  const std::string failures = FormatFailures(all);
  std::printf("%s", failures.c_str());
  return failures.empty() ? kSuccess : kFailedVerdict;
}

}  // namespace
}  // namespace dgd_physics

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_physics::ParseCommandLine(argc, argv), dgd_physics::Run);
}
