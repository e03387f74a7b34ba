// The command line of polytope_drop.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "exit_status.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {

struct Options {
  std::filesystem::path scene;
  std::vector<Narrowphase> narrowphases;  ///< In the order in which they run.
  std::uint64_t seed = 1;
  std::filesystem::path out = "out";
  bool draw_snapshots = true;
  bool record = false;             ///< What the narrowphases are asked.
  std::optional<double> duration;  ///< s
  int oracle_every = 1;            ///< Steps.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_demos
