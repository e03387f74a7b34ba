// Scene files: JSON in, a checked Scene out. scenes/README.md describes the format.
#pragma once

#include <filesystem>

#include "scene/scene.h"
#include "scene/scene_error.h"

namespace dgd_demos {

/// Reads a scene file and the meshes it names (their paths are relative to the scene file).
/// @throws SceneError that names file, JSON path and value; for broken JSON, line and column.
Scene LoadScene(const std::filesystem::path& file);

}  // namespace dgd_demos
