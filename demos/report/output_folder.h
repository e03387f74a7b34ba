// Folders for results.
#pragma once

#include <filesystem>

namespace dgd_demos {

/// Makes a folder, with those that it is in, unless it is there.
/// @throws std::runtime_error with the folder and the reason if it cannot be made, as where a file has its name.
void MakeOutputFolder(const std::filesystem::path& folder);

}  // namespace dgd_demos
