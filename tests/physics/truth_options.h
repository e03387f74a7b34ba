// The command line of physics_truth.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace dgd_physics {

enum ExitStatus {
  kSuccess = 0,
  kFailedVerdict = 1,  ///< Ours is farther from theory than its bound.
  kBadInput = 2,       ///< Command line; or the output cannot be written.
};

struct TruthOptions {
  std::vector<std::string> classes;  ///< All if empty.
  std::vector<double> rates = {60, 240, 1000};
  bool is_quick = false;
  bool in_compounds = false;
  bool lists_cases = false;
  std::filesystem::path csv;  ///< Empty for none.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<TruthOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_physics
