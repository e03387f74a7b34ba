// The option --duration of the programs whose scenes have no duration of their own.
#pragma once

#include "command_line.h"

namespace dgd_bench {

inline void AddDurationOption(dgd_demos::CommandLine& line, double& duration) {
  line.AddNumber("--duration", "S", duration, {0.1, 3600}, "Simulated seconds");
}

}  // namespace dgd_bench
