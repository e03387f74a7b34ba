// Worlds as .bullet files, for other programs that read Bullet's. Bullet's serializer is in its base library: this
// needs no importer.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "simulation/simulated_world.h"

class btCollisionObject;
class btDynamicsWorld;

namespace dgd_demos {

using BodyNames = std::map<const btCollisionObject*, std::string>;

/// Writes what Bullet's serializer writes: bodies with shapes and velocities, constraints, multibodies, gravity and
/// settings of the solver; no soft bodies and no vehicles. In this Bullet's precision. The file is complete or
/// is not there.
/// @param world  is not changed; Bullet's serializer asks for one that might be.
/// @param names  of bodies; those without are written without.
/// @throws std::runtime_error with the file and the reason if it cannot be written.
void WriteWorldFile(btDynamicsWorld& world, const BodyNames& names, const std::filesystem::path& file);

/// With the bodies' names, and its time step for whoever reads it.
void WriteWorldFile(SimulatedWorld& world, const std::filesystem::path& file);

}  // namespace dgd_demos
