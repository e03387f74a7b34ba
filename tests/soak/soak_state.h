// All that a soak knows at some point: which cases are done, and what they came to. Saved to a file and read again, it
// goes on as if it had never stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "support/pairs/tally.h"

namespace dgd_soak {

struct SoakState {
  /// The first failing cases are remembered for the report, no more of them.
  static constexpr std::size_t kMaxFailures = 20;

  /// @param case_options  SoakOptions::CaseOptions() of the run.
  explicit SoakState(std::string case_options);

  std::string case_options;
  std::int64_t done = 0;                             ///< Of the cases that the options choose, the first so many.
  std::vector<dgd_test::Tally> in_double, in_float;  ///< By AllTypePairs().
  std::vector<std::int64_t> failures;                ///< Indices of the first failing cases.

  /// Adds what the next cases came to.
  void Merge(const SoakState& next);
};

/// Writes the file all at once: whoever reads it, or stops the program, sees the old state or the new one.
/// Throws std::runtime_error with the file's name.
void Save(const SoakState& state, const std::filesystem::path& file);

/// Throws std::runtime_error with the file's name if it is no state, or one of other options.
SoakState Load(const std::filesystem::path& file, const std::string& case_options);

}  // namespace dgd_soak
