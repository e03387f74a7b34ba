// Mesh files as convex hulls.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "scene/limited_child.h"
#include "scene/polyhedron.h"

namespace dgd_demos {

/// What the import of a file of so many bytes may take.
ChildLimits ImportLimits(std::uint64_t file_size);

/// Reads a mesh in any format that assimp knows, scales it, and takes the hull of all its vertices (their faces do not
/// matter). The hull's centre of mass becomes the local origin; the axes stay the file's. A file that is damaged may
/// have the importer crash or never end: it runs in a child process.
/// @param scale   from the file's unit to metres, > 0.
/// @param limits  of the import; by default, ImportLimits().
/// @throws std::runtime_error with the reason if the file cannot be read, or its vertices lie in a plane or far out.
Polyhedron LoadConvexMesh(const std::filesystem::path& file, double scale,
                          std::optional<ChildLimits> limits = std::nullopt);

}  // namespace dgd_demos
