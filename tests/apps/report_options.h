// The command line of apps_report.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace dgd_apps {

enum ExitStatus {
  kSuccess = 0,
  kFailedVerdict = 1,  ///< Ours is worse than the built-in by more than a figure's band.
  kBadInput = 2,       ///< Command line; or the output cannot be written.
};

struct ReportOptions {
  std::vector<std::string> apps;  ///< All if empty.
  std::vector<double> rates = {60, 240, 1000};
  bool is_quick = false;
  bool lists_cases = false;
  bool lists_bands = false;
  std::filesystem::path csv;  ///< Empty for none.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<ReportOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_apps
