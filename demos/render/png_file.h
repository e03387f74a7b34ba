// Pictures as PNG files.
#pragma once

#include <filesystem>

#include "render/image.h"

namespace dgd_demos {

/// @throws std::runtime_error with libpng's reason if the file cannot be written.
void WritePng(const std::filesystem::path& file, const Image& image);

}  // namespace dgd_demos
