// Files that a run appends to, and that a run which continues from a checkpoint goes on with.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "checkpoint/state_archive.h"

namespace dgd_demos {

enum class OpenMode {
  kCreate,    ///< As CreateFile().
  kContinue,  ///< Leaves it as it is, until Serialize() cuts off what was written after the checkpoint.
};

/// Opens a file for writing at any place: a new one, or one that is there and is no link.
/// @return null, with the reason in errno, if it cannot be opened.
std::FILE* OpenFile(const std::filesystem::path& file, OpenMode mode);

/// Writing: waits until the file is on the disk, and adds its size and a hash of its end. Reading: cuts the file to
/// that size.
/// @param file  all of which has been handed to the operating system.
/// @param head  so many bytes at the file's beginning are written again as it grows.
/// @return the size, bytes.
/// @throws std::runtime_error if the file is missing, shorter than that, or ends otherwise.
std::uint64_t SerializeContinuedFile(StateArchive& archive, const std::filesystem::path& file, std::uint64_t head = 0);

}  // namespace dgd_demos
