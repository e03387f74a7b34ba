// Writes worlds as .bullet files, for other programs. Bullet's serializer is in its base library, so that this needs no
// importer.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "simulation/simulated_world.h"

class btCollisionObject;
class btDynamicsWorld;

namespace dgd_demos {

using BodyNames = std::map<const btCollisionObject*, std::string>;

/// Writes what Bullet's serializer writes, in this Bullet's precision: bodies with shapes and velocities, constraints,
/// multibodies, gravity and settings of the solver; no soft bodies and no vehicles. The file is complete or does not
/// exist.
/// @param world  Not changed, though Bullet's serializer takes it as not const.
/// @param names  Names of bodies; other bodies are written without.
/// @throws std::runtime_error with the file and the reason if it cannot be written.
void WriteWorldFile(btDynamicsWorld& world, const BodyNames& names, const std::filesystem::path& file);

/// Writes the bodies' names and the time step as well.
void WriteWorldFile(SimulatedWorld& world, const std::filesystem::path& file);

}  // namespace dgd_demos
