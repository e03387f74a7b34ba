// Trajectories that a run has left, for pictures of them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "report/npy_file.h"
#include "simulation/snapshot.h"

namespace dgd_demos {

/// Columns of a trajectory: those of TrajectoryFile, which describes them.
std::vector<NpyFile::Column> TrajectoryColumns();

/// A file that TrajectoryFile has written, of a run that was killed as well: what its head counts is there. Reads one
/// sample at a time, so that the length of a run does not matter.
class TrajectoryReader {
 public:
  /// Reads the head, and checks all times.
  /// @throws SceneError in a sentence that names file, place and value: what is no trajectory, is cut off, has a time
  ///         that is not finite or is not after the one before.
  explicit TrajectoryReader(const std::filesystem::path& file);

  std::size_t bodies() const { return bodies_; }               ///< At least 1.
  const std::vector<double>& times() const { return times_; }  ///< Of the samples, s, ascending; at least one.

  /// Index of the sample nearest to a time, s.
  /// @throws SceneError if the trajectory ends, or begins, more than a sample's interval away from it.
  std::size_t NearestSample(double time) const;

  /// Poses and speeds in the world frame.
  /// @throws SceneError about a pose or a velocity that is not finite, a position farther than 1e9 m from the origin,
  ///         or an orientation that is not a unit quaternion.
  Snapshot At(std::size_t sample);

 private:
  void ReadHead();
  // @param head  the dictionary, without blanks. @param data_size  bytes after it.
  void ParseHead(const std::string& head, std::uintmax_t data_size);
  void ReadTimes();
  // Fills `size` doubles from an offset in the file. @throws SceneError if it ends before.
  void Read(std::size_t offset, double* numbers, std::size_t size);
  [[noreturn]] void Fail(const std::string& complaint) const;

  std::filesystem::path file_;
  std::ifstream stream_;
  std::size_t data_ = 0;  // Offset of the first sample, bytes.
  std::size_t samples_ = 0, bodies_ = 0;
  std::vector<double> times_;
};

}  // namespace dgd_demos
