// Random numbers that are the same on every machine: raw generator output, mapped by hand, since the standard leaves
// its distributions to the library.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace dgd_test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Unit(); }
  /// Uniform in the logarithm; 0 < low <= high.
  double LogUniform(double low, double high) { return low * std::exp(Unit() * std::log(high / low)); }
  /// 0 ... count - 1.
  int Below(int count) { return static_cast<int>(Unit() * count); }
  bool Flip() { return Unit() < 0.5; }
  /// Each coordinate uniform in [-1, 1).
  Eigen::Vector3d InCube();
  Eigen::Vector3d UnitVector();
  /// Uniform over all rotations.
  Eigen::Matrix3d Rotation();

 private:
  double Unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  std::mt19937_64 engine_;
};

/// Environment variable DGD_TEST_SEED, else 1. Printed when first asked for.
std::uint64_t TestSeed();

/// How many cases a random test runs: `usual`, scaled as the environment variable DGD_TEST_PAIRS, the count of the
/// largest test, stands to its usual kUsualPairs; at least `least`. DGD_TEST_PAIRS is printed when first asked for.
int TestCount(int usual, int least = 10);
inline constexpr int kUsualPairs = 100000;

}  // namespace dgd_test
