// Scene files: JSON in, a checked Scene out. scenes/README.md describes the format.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_error.h"

namespace dgd_demos {

/// Values of a scene by their JSON path ("/bodies/0/friction"), in place of the file's own.
using SceneChanges = std::vector<std::pair<std::string, nlohmann::json>>;

/// Reads a scene file and the meshes it names (their paths are relative to the scene file).
/// @throws SceneError that names file, JSON path and value; for broken JSON, line and column.
Scene LoadScene(const std::filesystem::path& file, const SceneChanges& changes = {});

}  // namespace dgd_demos
