// Files that are complete, or are not there.
#pragma once

#include <filesystem>
#include <string_view>

namespace dgd_demos {

/// Writes another file in the same folder, to the disk, and renames it: no reader sees a part, whenever this process or
/// another one that writes the same file dies.
/// @param content  bytes.
/// @throws std::runtime_error with the file and the reason, as on a full disk; the file is then as it was.
void WriteWholeFile(const std::filesystem::path& file, std::string_view content);

}  // namespace dgd_demos
