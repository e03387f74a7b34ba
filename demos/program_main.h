// What main() of every program does once its command line is parsed.
#pragma once

#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <variant>

namespace dgd_demos {

/// Runs the program with its options, unless parsing has ended it. What it throws goes to standard error.
/// @param parsed  Options, or the exit status to end with.
/// @return the exit status; ExitStatus::kBadInput for an exception.
template <class Options, class ExitStatus>
int RunProgram(const std::variant<Options, ExitStatus>& parsed, ExitStatus (*run)(const Options& options)) {
  if (const auto* status = std::get_if<ExitStatus>(&parsed)) return *status;
  try {
    const ExitStatus status = run(std::get<Options>(parsed));
    // Of what was printed, on a full disk say, the last part is only now written.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::runtime_error("standard output cannot be written");
    return status;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::kBadInput;
  }
}

}  // namespace dgd_demos
