// The soak's tables, for people and for programs.
#pragma once

#include <filesystem>
#include <string>

#include "soak/soak_options.h"
#include "soak/soak_state.h"

namespace dgd_soak {

/// A table for each scalar, a line for each pair of types, then one for each class; and how to replay what failed.
std::string FormatReport(const SoakState& state, const SoakOptions& options);

/// The same as CSV, with the index of each worst case. Throws std::runtime_error if the file cannot be written.
void WriteCsv(const SoakState& state, const SoakOptions& options, const std::filesystem::path& file);

bool HasFailures(const SoakState& state);

}  // namespace dgd_soak
