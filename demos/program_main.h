// What main() of every program does once its command line is parsed.
#pragma once

#include <exception>
#include <iostream>
#include <variant>

namespace dgd_demos {

/// Runs the program with its options, unless parsing has ended it. What it throws goes to standard error.
/// @param parsed  Options, or the exit status to end with.
/// @return the exit status; ExitStatus::kBadInput for an exception.
template <class Options, class ExitStatus>
int RunProgram(const std::variant<Options, ExitStatus>& parsed, ExitStatus (*run)(const Options& options)) {
  if (const auto* status = std::get_if<ExitStatus>(&parsed)) return *status;
  try {
    return run(std::get<Options>(parsed));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::kBadInput;
  }
}

}  // namespace dgd_demos
