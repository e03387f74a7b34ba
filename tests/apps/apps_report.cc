// apps_report: small programs as users write them, on Bullet's built-in narrowphase and on the plugin. See --help.
#include <LinearMath/btScalar.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/apps.h"
#include "apps/report_options.h"
#include "apps/verdict.h"
#include "program_main.h"

namespace dgd_apps {
namespace {

constexpr const char* kPrecision = sizeof(btScalar) == sizeof(double) ? "double" : "float";

/// The figures of all cases, and those groups that fail at some rate.
/// @param columns  One a rate.
void PrintRows(const std::vector<std::vector<Verdict>>& columns, bool lists_bands) {
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    std::vector<Verdict> row;
    for (const std::vector<Verdict>& column : columns) row.push_back(column[i]);
    const bool is_all = row.front().group.empty();
    if (!is_all && std::ranges::all_of(row, &Verdict::Passes)) continue;
    std::printf("%s", FormatRow(row).c_str());
    const Figure& figure = *row.front().figure;
    if (lists_bands && is_all)
      std::printf("    + %g %% + %g: %s\n", 100 * figure.band, figure.floor, std::string(figure.reason).c_str());
  }
}

void WriteCsv(const std::filesystem::path& file, const std::vector<Runs>& all) {
  std::ofstream stream(file);
  stream << FormatCsv(all, kPrecision) << std::flush;
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

ExitStatus Run(const ReportOptions& options) {
  std::printf("Bullet in %s%s\n%s", kPrecision, options.is_quick ? "; some cases only" : "",
              FormatHeading(options.rates).c_str());
  std::vector<Runs> all;
  std::string failures;
  for (const App& app : Apps()) {
    if (!options.apps.empty() && std::ranges::count(options.apps, app.name) == 0) continue;
    std::vector<std::vector<Verdict>> columns;
    for (const double rate : options.rates) {
      all.push_back(RunBoth(app, rate, options.is_quick));
      columns.push_back(Judge(all.back()));
      failures += FormatFailures(columns.back());
      if (options.lists_cases) std::printf("%s", FormatCases(all.back()).c_str());
    }
    PrintRows(columns, options.lists_bands);
    std::fflush(stdout);
  }
  if (!options.csv.empty()) WriteCsv(options.csv, all);
  std::printf("%s", failures.c_str());
  return failures.empty() ? kSuccess : kFailedVerdict;
}

}  // namespace
}  // namespace dgd_apps

int main(int argc, char** argv) { return dgd_demos::RunProgram(dgd_apps::ParseCommandLine(argc, argv), dgd_apps::Run); }
