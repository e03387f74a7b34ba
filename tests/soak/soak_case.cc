#include "soak/soak_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace dgd_soak {
namespace {

using dgd_test::LengthRange;
using dgd_test::Placement;
using dgd_test::Random;

// Of a set's longest length to its shortest.
constexpr double kLargestSkew = 1000;
// Geometric mean of a set's length range, metres.
constexpr double kSmallestSize = 0.1, kLargestSize = 2;

/// Neighbouring seeds and indices give unrelated streams (splitmix64).
std::uint64_t Mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

LengthRange RandomRange(Random& random) {
  const double size = random.LogUniform(kSmallestSize, kLargestSize);
  const double skew = random.LogUniform(1, kLargestSkew);
  return {size / std::sqrt(skew), size * std::sqrt(skew)};
}

dgd_test::SetNumbers RandomSet(Random& random, dgd_test::SetType type) {
  const LengthRange range = RandomRange(random);
  return dgd_test::RandomSetOf(random, type, range, random.Flip());
}

Placement RandomPlacement(Random& random) {
  // Half of all are generic.
  return random.Flip() ? Placement::kGeneric : static_cast<Placement>(random.Below(dgd_test::kPlacementCount));
}

}  // namespace

const std::vector<TypePair>& AllTypePairs() {
  static const std::vector<TypePair> pairs = [] {
    std::vector<TypePair> all;
    for (const auto& info_1 : dgd_test::kSetTypes) {
      for (const auto& info_2 : dgd_test::kSetTypes) {
        if (info_1.type <= info_2.type && info_1.dimension == info_2.dimension) {
          all.push_back({info_1.type, info_2.type});
        }
      }
    }
    return all;
  }();
  return pairs;
}

SoakCase MakeCase(std::uint64_t seed, std::int64_t index, int frames) {
  Random random(Mix(Mix(seed) + static_cast<std::uint64_t>(index)));
  SoakCase soak_case{};
  soak_case.index = index;
  soak_case.type_pair = static_cast<std::size_t>(index) % AllTypePairs().size();
  const TypePair& types = AllTypePairs()[soak_case.type_pair];

  dgd_test::PairNumbers& pair = soak_case.pair;
  pair.set_1 = RandomSet(random, types.type_1);
  pair.set_2 = RandomSet(random, types.type_2);
  if (random.Flip()) std::swap(pair.set_1, pair.set_2);
  // Two flat sets have no growth distance.
  if (!pair.set_1.HasInterior() && !pair.set_2.HasInterior()) pair.set_1.radius = pair.set_1.lengths.minCoeff();
  soak_case.placement = RandomPlacement(random);
  soak_case.growth_distance = Place(random, soak_case.placement, pair);

  const double extent = std::max(pair.set_1.lengths.maxCoeff(), pair.set_2.lengths.maxCoeff());
  dgd_test::PoseNumbers pose = pair.pose_2;
  soak_case.motion.reserve(static_cast<std::size_t>(frames));
  for (int frame = 0; frame < frames; ++frame) {
    // Products of so many rotations would drift from orthonormal.
    if (frame > 0 && frame % 16 == 0) pose.rotation = Eigen::Quaterniond(pose.rotation).normalized().toRotationMatrix();
    pose = MovedALittle(random, pose, types.Dimension(), kMotion, extent);
    soak_case.motion.push_back(pose);
  }
  return soak_case;
}

}  // namespace dgd_soak
