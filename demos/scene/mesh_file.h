// Mesh files as convex hulls.
#pragma once

#include <filesystem>

#include "scene/polyhedron.h"

namespace dgd_demos {

/// Reads a mesh in any format that assimp knows, scales it, and takes the hull of all its vertices (their faces do not
/// matter). The hull's centre of mass becomes the local origin; the axes stay the file's.
/// @param scale  from the file's unit to metres, > 0.
/// @throws std::runtime_error with the reason if the file cannot be read, or its vertices lie in a plane.
Polyhedron LoadConvexMesh(const std::filesystem::path& file, double scale);

}  // namespace dgd_demos
