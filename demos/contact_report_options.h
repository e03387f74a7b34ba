// The command line of contact_report.
#pragma once

#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "exit_status.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {

struct ContactReportOptions {
  std::vector<std::filesystem::path> scenes;  ///< In the order in which they run.
  std::vector<Narrowphase> narrowphases;      ///< The first is what the others are compared with.
  int seeds = 3;                              ///< Of scenes with random bodies: 1, 2 and so on.
  std::filesystem::path out;
  std::optional<double> duration;  ///< s
  int oracle_every = 1;            ///< Steps.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<ContactReportOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_demos
