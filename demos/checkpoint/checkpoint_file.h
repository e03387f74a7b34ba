// Checkpoints on disk: which run it is, and its state.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "checkpoint/state_archive.h"

namespace dgd_demos {

/// Replaces the file by a complete one.
/// @param run  all that the run's results depend on, as an object of names and values.
/// @throws std::runtime_error if it cannot be written.
void WriteCheckpoint(const std::filesystem::path& file, const nlohmann::json& run, const StateArchive& state);

/// @return the state, or nothing if there is no such file.
/// @throws std::runtime_error if the file is damaged or no checkpoint, or if it is of another run: the first value that
///         differs is named.
std::optional<StateArchive> ReadCheckpoint(const std::filesystem::path& file, const nlohmann::json& run);

}  // namespace dgd_demos
