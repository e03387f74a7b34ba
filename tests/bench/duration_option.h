// The option --duration of the programs whose scenes have no duration of their own.
#pragma once

#include <CLI/CLI.hpp>

namespace dgd_bench {

inline void AddDurationOption(CLI::App& app, double& duration) {
  constexpr double kShortest = 0.1, kLongest = 3600;
  app.add_option("--duration", duration, "Simulated seconds")
      ->type_name("S")
      ->check(CLI::Range(kShortest, kLongest).description(""))
      ->capture_default_str();
}

}  // namespace dgd_bench
