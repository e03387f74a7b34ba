// The command line of `headless_sim render`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "exit_status.h"

namespace dgd_demos {

struct RenderOptions {
  std::filesystem::path world;       ///< A scene, or a world file of Bullet's.
  std::filesystem::path trajectory;  ///< What `run` has left of that world.
  std::filesystem::path out;
  bool overwrite = false;  ///< Replaces pictures of another trajectory in `out`.
  std::uint64_t seed = 1;
  std::vector<double> times;       ///< s; empty: those of the scene, or begin, middle and end.
  std::optional<double> every;     ///< A film: simulated time from one frame to the next, s.
  int width = 1280, height = 720;  ///< Pixels.
};

/// The options, or the exit status if the program is to end now: after --help, or with a complaint on standard error.
std::variant<RenderOptions, ExitStatus> ParseRenderOptions(int argc, const char* const* argv);

}  // namespace dgd_demos
