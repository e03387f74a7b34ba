// Whether a world is still the same: a hash of all that is read for it.
#pragma once

#include <filesystem>
#include <string>

namespace dgd_demos {

/// Hash of a scene (.json) with the mesh files that it names, or of another file alone; see HashOf(). What a mesh file
/// refers to in turn is not read.
/// @throws std::runtime_error if a file cannot be read; SceneError if a scene is not JSON.
std::string HashOfWorld(const std::filesystem::path& file);

}  // namespace dgd_demos
