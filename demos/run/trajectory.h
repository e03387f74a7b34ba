// Output of a run for NumPy: poses and velocities of its bodies, and the contacts between them.
#pragma once

#include <filesystem>

#include "report/npy_file.h"
#include "simulation/simulated_world.h"

namespace dgd_demos {

/// numpy.load(FILE)["position"][t, b] is the position of body b at the t-th sample. Columns, in SI units and the world
/// frame: time, position (of the centre of mass), orientation (a quaternion x, y, z, w), velocity (of the centre of
/// mass), angular_velocity.
class TrajectoryFile {
 public:
  /// @throws std::runtime_error if the file cannot be written.
  TrajectoryFile(const std::filesystem::path& file, const SimulatedWorld& world, OpenMode mode = OpenMode::kCreate);
  /// Adds a sample, and now and then flushes.
  void Add(double time, const SimulatedWorld& world);
  void Flush() { file_.Flush(); }
  void Serialize(StateArchive& archive) { file_.Serialize(archive); }

 private:
  NpyFile file_;
};

/// numpy.load(FILE) has a row for each contact point of each sample. Columns, in SI units and the world frame: time, at
/// the end of a step; body_a, body_b (as in bodies.csv); position_a, position_b (of the point, on either body); normal
/// (unit, from B to A); distance (negative where the bodies overlap); impulse (along the normal, in the step, N s).
/// Points are those of the step's collision detection, at the poses with which it began: one step before `time`. The
/// plugin's contacts that the step closes have a distance of -1e-9, and places that are still apart.
class ContactFile {
 public:
  /// @throws std::runtime_error if the file cannot be written.
  explicit ContactFile(const std::filesystem::path& file, OpenMode mode = OpenMode::kCreate);
  /// Adds the points of a sample, and now and then flushes.
  void Add(double time, SimulatedWorld& world);
  void Flush() { file_.Flush(); }
  void Serialize(StateArchive& archive) { file_.Serialize(archive); }

 private:
  NpyFile file_;
};

/// Writes the number of each body, its name, and whether it moves: the rows of a trajectory's samples.
/// @throws std::runtime_error if the file cannot be written.
void WriteBodyList(const std::filesystem::path& file, const SimulatedWorld& world);

}  // namespace dgd_demos
