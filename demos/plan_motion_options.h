// The command line of plan_motion.
#pragma once

#include <cstdint>
#include <filesystem>
#include <variant>

#include "exit_status.h"
#include "motion/sampling_planner.h"

namespace dgd_demos {

struct PlanMotionOptions {
  std::filesystem::path scene;
  std::filesystem::path out;
  bool overwrite = false;  ///< Replaces results of another run in `out`.
  PlannerKind planner = PlannerKind::kRrtConnect;
  std::uint64_t seed = 1;
  int seeds = 1;          ///< Runs, with this seed and the ones that follow it.
  double time_limit = 5;  ///< Of each run's planning, s.
  bool compares = false;  ///< With Bullet's and FCL's checks.
  bool draws = true;
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<PlanMotionOptions, ExitStatus> ParseCommandLine(int argc, const char* const* argv);

}  // namespace dgd_demos
