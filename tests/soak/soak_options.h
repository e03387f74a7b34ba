// The command line of dgd_soak.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "soak/examine.h"

namespace dgd_soak {

/// Exit statuses, as --help lists them.
enum ExitStatus {
  kSuccess = 0,
  kFailedCase = 1,
  kBadInput = 2,  ///< Command line or state file; or the output cannot be written.
  kInterrupted = 3,
};

struct SoakOptions {
  std::int64_t pairs = 100000;
  std::uint64_t seed = 1;
  std::vector<dgd_test::SetType> types;  ///< Both of a pair are among these; empty for all.
  bool in_double = true, in_float = true;
  Query query;
  int frames = kMotionFrames;  ///< Of each pair, warm.
  int threads = 1;
  std::filesystem::path csv;    ///< Empty for none.
  std::filesystem::path state;  ///< Where the progress is kept; empty for nowhere.
  bool is_resumed = false;      ///< The state is there already.
  std::optional<std::int64_t> replay;
  bool shrink = false;  ///< And look for a simpler case that fails alike.

  /// What decides a case and how it is asked, as options on the command line: a replay needs them, and a state is of
  /// one of these.
  std::string CaseOptions() const;
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<SoakOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_soak
