#include "support/random.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace dgd_test {
namespace {

/// A whole number >= 1 from the environment; prints what is used. A value that is no such number ends the program:
/// running another number of cases than asked for would be worse.
std::uint64_t FromEnvironment(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);
  std::uint64_t value = usual;
  if (text != nullptr) {
    char* end = nullptr;
    value = std::strtoull(text, &end, 10);
    if (*end != '\0' || value == 0) {
      std::fprintf(stderr, "%s must be a whole number >= 1; got \"%s\"\n", name, text);
      std::exit(2);
    }
  }
  std::printf("%s=%llu\n", name, static_cast<unsigned long long>(value));
  return value;
}

}  // namespace

Eigen::Vector3d Random::InCube() {
  // One statement each: the order of evaluation inside a call is the compiler's choice.
  const double x = Uniform(-1, 1);
  const double y = Uniform(-1, 1);
  const double z = Uniform(-1, 1);
  return {x, y, z};
}

Eigen::Vector3d Random::UnitVector() {
  for (;;) {
    const Eigen::Vector3d point = InCube();
    const double length_sq = point.squaredNorm();
    if (length_sq > 1e-4 && length_sq <= 1) return point / std::sqrt(length_sq);
  }
}

Eigen::Matrix3d Random::Rotation() {
  for (;;) {
    const double w = Uniform(-1, 1);
    const Eigen::Vector3d xyz = InCube();
    const double length_sq = w * w + xyz.squaredNorm();
    if (!(length_sq > 1e-4 && length_sq <= 1)) continue;
    return Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z()).normalized().toRotationMatrix();
  }
}

std::uint64_t TestSeed() {
  static const std::uint64_t seed = FromEnvironment("DGD_TEST_SEED", 1);
  return seed;
}

int TestCount(int usual, int least) {
  static const std::uint64_t pairs = FromEnvironment("DGD_TEST_PAIRS", kUsualPairs);
  const double scaled = static_cast<double>(usual) * static_cast<double>(pairs) / kUsualPairs;
  return std::max(least, static_cast<int>(std::min(scaled, 1e9)));
}

}  // namespace dgd_test
