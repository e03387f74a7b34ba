#include "scene/random.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dgd_demos {

using Eigen::Vector3d;

namespace {

// Uniform on the unit sphere in N dimensions, by rejection from the cube.
template <int N>
Eigen::Matrix<double, N, 1> UnitVectorIn(Random& random) {
  constexpr double kLeastNorm = 0.1;  // Keeps the quotient accurate.
  while (true) {
    Eigen::Matrix<double, N, 1> candidate;
    // Summed here, since the order in which Eigen's norm() adds depends on the machine's vector unit.
    double norm_sq = 0;
    for (double& coordinate : candidate) {
      coordinate = random.Uniform(-1, 1);
      norm_sq += coordinate * coordinate;
    }
    const double norm = std::sqrt(norm_sq);
    if (norm <= 1 && norm > kLeastNorm) return candidate / norm;
  }
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint32_t stream) {
  std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), stream};
  bits_.seed(mixed);
}

double Random::Uniform(double low, double high) {
  constexpr double kUnit = 0x1p-53;  // The upper 53 bits fill a double's significand exactly.
  return low + (high - low) * (static_cast<double>(bits_() >> 11) * kUnit);
}

int Random::Integer(int low, int high) {
  // The quotient may round up to `high + 1`.
  return std::min(high, static_cast<int>(Uniform(low, high + 1.0)));
}

Vector3d Random::InBox(const Vector3d& low, const Vector3d& high) {
  // Not as constructor arguments: their order of evaluation is not fixed.
  Vector3d point;
  for (int i = 0; i < 3; ++i) point[i] = Uniform(low[i], high[i]);
  return point;
}

Vector3d Random::UnitVector() { return UnitVectorIn<3>(*this); }

Eigen::Matrix3d Random::Rotation() {
  // Unit quaternions cover the rotations evenly.
  return Eigen::Quaterniond(UnitVectorIn<4>(*this)).toRotationMatrix();
}

}  // namespace dgd_demos
