// The option --duration of the programs whose scenes have no duration of their own.
#pragma once

#include "command_line.h"

namespace dgd_bench {

inline void AddDurationOption(dgd_demos::CommandLine& line, double& duration) {
  constexpr double kShortest = 0.1, kLongest = 3600;
  line.AddNumber("--duration", "S", duration, {kShortest, kLongest}, "Simulated seconds");
}

}  // namespace dgd_bench
