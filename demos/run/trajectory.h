// What a run leaves for NumPy: where its bodies were and how they moved, and the contacts between them.
#pragma once

#include <filesystem>

#include "report/npy_file.h"
#include "simulation/simulated_world.h"

namespace dgd_demos {

/// numpy.load(FILE)["position"][t, b]: of body b at the t-th sample. Columns, in SI units and the world frame: time,
/// position (of the centre of mass), orientation (a quaternion x, y, z, w), velocity, angular_velocity.
class TrajectoryFile {
 public:
  /// @throws std::runtime_error if the file cannot be written.
  TrajectoryFile(const std::filesystem::path& file, const SimulatedWorld& world);
  void Add(double time, const SimulatedWorld& world);

 private:
  NpyFile file_;
};

/// numpy.load(FILE): a row for each contact point of each sample. Columns: time; body_a, body_b (as in bodies.csv);
/// position_a, position_b (of the point, on either body); normal (from B to A); distance (negative where they overlap);
/// impulse (along the normal, of the last step, N s).
class ContactFile {
 public:
  /// @throws std::runtime_error if the file cannot be written.
  explicit ContactFile(const std::filesystem::path& file);
  void Add(double time, SimulatedWorld& world);

 private:
  NpyFile file_;
};

/// bodies.csv: the number of each body, its name, and whether it moves.
/// @throws std::runtime_error if the file cannot be written.
void WriteBodyList(const std::filesystem::path& file, const SimulatedWorld& world);

}  // namespace dgd_demos
