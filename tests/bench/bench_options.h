// The command line of hull_pairs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

#include "bench/exit_status.h"
#include "bench/hull_pair.h"
#include "bench/measurement.h"

namespace dgd_bench {

struct BenchOptions {
  int pairs = 2000;  ///< Of each class and margin.
  std::uint64_t seed = 1;
  std::vector<double> margins = {0, 0.04};  ///< m
  DistanceOf distance_of = DistanceOf::kSets;
  TimingEffort effort = {.repeats = 20, .rounds = 3};
  std::filesystem::path csv;  ///< Empty for none.
};

/// "sets" or "cores".
const char* NameOf(DistanceOf distance_of);

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<BenchOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_bench
