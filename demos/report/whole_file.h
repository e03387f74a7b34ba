// Files as a whole: written so that they are complete or do not exist, and read.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace dgd_demos {

/// Opens a new file for writing and reading, in the place of a file that has its name: what else is linked to that one
/// stays as it was.
/// @return null, with the reason in errno, if it cannot be made.
/// @throws std::runtime_error if a link, a pipe or a device has its name.
std::FILE* CreateFile(const std::filesystem::path& file);

/// Writes another file in the same folder, to the disk, and renames it: no reader sees a part, whenever this process or
/// another writer of the same file dies.
/// @param content  bytes.
/// @throws std::runtime_error with the file and the reason, as on a full disk; the file is then as it was.
void WriteWholeFile(const std::filesystem::path& file, std::string_view content);

/// Removes what writers of the file have left that died.
/// @pre nobody is writing it.
void RemoveParts(const std::filesystem::path& file);

/// @return the file's bytes.
/// @throws std::runtime_error if it cannot be read.
std::string ReadWholeFile(const std::filesystem::path& file);

/// FNV-1a in 16 hexadecimal digits: enough to notice that a file has changed or is damaged.
std::string HashOf(std::string_view content);

/// The size, and the hash of the last 64 kB, of a file of any size: enough to tell another file.
/// @throws std::runtime_error if it cannot be read.
std::string HashOfSizeAndEnd(const std::filesystem::path& file);

}  // namespace dgd_demos
