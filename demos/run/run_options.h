// The command line of `headless_sim run`, and of polytope_drop, which is the same with a scene of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "exit_status.h"

namespace dgd_demos {

struct RunOptions {
  std::filesystem::path world;            ///< A scene, or a world file of Bullet's.
  std::vector<std::string> narrowphases;  ///< As NarrowphaseChoice::Name(), in the order in which they run.
  std::string precision;                  ///< "float", "double" or "both"; empty: this program's.
  std::uint64_t seed = 1;
  std::filesystem::path out;
  bool overwrite = false;  ///< Replaces results of another run in `out`.
  bool draw_snapshots = true;
  bool record = false;  ///< Record the queries of each narrowphase.
  bool write_trajectory = false, write_contacts = false;
  double sample_interval = 0;                 ///< Time between samples of trajectory and contacts, s; 0: every step.
  std::optional<double> duration, time_step;  ///< s
  int oracle_every = 1;                       ///< Steps.
  std::optional<double> checkpoint_interval;  ///< Wall time between checkpoints, s, >= 0; without it, there are none.
  bool resume = false;                        ///< Continue from the checkpoints that are there.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<RunOptions, ExitStatus> ParseRunOptions(int argc, const char* const* argv);
std::variant<RunOptions, ExitStatus> ParsePolytopeDropOptions(int argc, const char* const* argv);

/// Path of a scene of this project by its name ("tower_20"), or of any file; a name that no scene has is returned as it
/// is.
std::filesystem::path WorldFileNamed(const std::filesystem::path& world);

}  // namespace dgd_demos
