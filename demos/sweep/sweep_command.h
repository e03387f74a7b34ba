// `headless_sim sweep`: carries out the runs of a study that are not done yet.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "exit_status.h"

namespace dgd_demos {

struct SweepOptions {
  std::filesystem::path study;
  std::filesystem::path out;  ///< Folder of the results.
  int jobs = 1;               ///< Runs at a time, on this machine.
  int shard = 0, shards = 1;  ///< Runs of this process: those with number % shards == shard.
  bool retry_failed = false;
  std::vector<std::string> merge;  ///< Folders of shards, whose records are gathered; nothing is run.
};

std::variant<SweepOptions, ExitStatus> ParseSweepOptions(int argc, const char* const* argv);

/// @throws SceneError, std::runtime_error
ExitStatus Sweep(const SweepOptions& options);

}  // namespace dgd_demos
