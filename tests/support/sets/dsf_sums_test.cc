#include "support/sets/dsf_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "support/random_sets.h"

namespace dgd_test {
namespace {

using dsf_internal::kBlock;
using dsf_internal::kLanes;
using dsf_internal::Powers;
using dsf_internal::Sums;

Powers PowersOf(double exponent) {
  const bool is_whole = exponent == std::floor(exponent);
  return {exponent, is_whole ? static_cast<std::uint32_t>(exponent) - 2 : 0, std::exp2(-70 / (exponent - 2))};
}

struct Offsets {
  explicit Offsets(Random& random, std::size_t blocks) : coordinates(blocks * kBlock) {
    for (double& coordinate : coordinates) coordinate = random.Uniform(-1, 1);
  }
  Eigen::Vector3d At(std::size_t j) const {
    const double* at = &coordinates[j / kLanes * kBlock + j % kLanes];
    return {at[0], at[kLanes], at[2 * kLanes]};
  }
  std::size_t Blocks() const { return coordinates.size() / kBlock; }

  std::vector<double> coordinates;
};

Sums SumsOf(const Offsets& offsets, const Eigen::Vector3d& direction, const Powers& powers) {
  Sums sums;
  dsf_internal::Sum(offsets.coordinates.data(), offsets.Blocks(), direction.data(), powers, true, sums);
  return sums;
}

TEST(DsfSums, AreThoseOfThePowersInExtendedPrecision) {
  Random random(TestSeed());
  for (const double exponent : {2.25, 3.0, 7.5, 12.0, 13.0, 100.0, 333.3}) {
    SCOPED_TRACE(exponent);
    const Powers powers = PowersOf(exponent);
    const Offsets offsets(random, 11);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3d direction = random.UnitVector();
      const Sums sums = SumsOf(offsets, direction, powers);
      long double total = 0, offset = 0, spread = 0;
      for (std::size_t j = 0; j < offsets.Blocks() * kLanes; ++j) {
        const Eigen::Vector3d w = offsets.At(j);
        EXPECT_GE(sums.highest, direction.dot(w) - 1e-15);
        const long double part = static_cast<long double>(direction.dot(w)) / sums.highest;
        if (!(part > 0)) continue;
        const long double u = w.x() - part * sums.top[0], v = w.y() - part * sums.top[1];
        total += std::pow(part, exponent);
        offset += std::pow(part, exponent - 1) * u;
        spread += std::pow(part, exponent - 2) * u * v;
      }
      // Heights are right to a last digit; powers of their parts to as many as the exponent says.
      const double digits = 1e-15 * (1 + exponent);
      EXPECT_NEAR(sums.powers, static_cast<double>(total), digits * static_cast<double>(total));
      EXPECT_NEAR(sums.offset[0], static_cast<double>(offset), 2 * digits * static_cast<double>(total));
      EXPECT_NEAR(sums.spread[1], static_cast<double>(spread), 4 * digits * static_cast<double>(total));
    }
  }
}

TEST(DsfSums, AreTheSameBitsOnAllProcessors) {
  if (!dsf_internal::HasAvx2()) GTEST_SKIP() << "this processor has no AVX2: there is nothing to compare";
  Random random(TestSeed());
  for (const double exponent : {2.5, 12.0, 40.7}) {
    const Powers powers = PowersOf(exponent);
    for (std::size_t blocks = 1; blocks < 20; ++blocks) {
      const Offsets offsets(random, blocks);
      const Eigen::Vector3d direction = random.UnitVector();
      const Sums sums = SumsOf(offsets, direction, powers);
      Sums wide;
      dsf_internal::SumAvx2(offsets.coordinates.data(), blocks, direction.data(), powers, true, wide);
      EXPECT_EQ(std::memcmp(&sums, &wide, sizeof sums), 0) << exponent << " " << blocks;
    }
  }
}

}  // namespace
}  // namespace dgd_test
