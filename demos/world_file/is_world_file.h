// Which files are Bullet's worlds, and not scenes.
#pragma once

#include <filesystem>

namespace dgd_demos {

inline bool IsWorldFile(const std::filesystem::path& file) { return file.extension() == ".bullet"; }

}  // namespace dgd_demos
