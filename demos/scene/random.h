// Random numbers that are the same on every machine. The standard fixes the bits of std::mt19937_64, but not what its
// distributions make of them, so the mapping is done here, with exactly rounded operations only (no sine, no
// logarithm).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace dgd_demos {

class Random {
 public:
  /// Streams of one seed are independent of each other.
  Random(std::uint64_t seed, std::uint32_t stream);

  /// In [low, high).
  double Uniform(double low, double high);
  /// In [low, high], ends included.
  int Integer(int low, int high);
  Eigen::Vector3d InBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  Eigen::Vector3d UnitVector();
  /// Uniform over all rotations.
  Eigen::Matrix3d Rotation();

 private:
  std::mt19937_64 bits_;
};

}  // namespace dgd_demos
