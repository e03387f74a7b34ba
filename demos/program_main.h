// What main() of every program does once its command line is parsed.
#pragma once

#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <variant>

#include "error_message.h"

namespace dgd_demos {

/// Calls a function that returns the exit status. What it throws goes to standard error.
/// @return its status, or `bad_input` for an exception.
template <class Function>
int RunGuarded(const Function& run, int bad_input) try {
  return run();
} catch (const std::exception& error) {
  std::cerr << MessageOf(error) << '\n';
  return bad_input;
}

/// Runs the program with its options, unless parsing has ended it. What it throws goes to standard error.
/// @param parsed  Options, or the exit status to end with.
/// @return the exit status; ExitStatus::kBadInput for an exception.
template <class Options, class ExitStatus>
int RunProgram(const std::variant<Options, ExitStatus>& parsed, ExitStatus (*run)(const Options& options)) {
  if (const auto* status = std::get_if<ExitStatus>(&parsed)) return *status;
  return RunGuarded(
      [&] {
        const ExitStatus status = run(std::get<Options>(parsed));
        // On a full disk, say, the last part of the output fails only now.
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
          throw std::runtime_error("standard output cannot be written");
        }
        return status;
      },
      ExitStatus::kBadInput);
}

}  // namespace dgd_demos
