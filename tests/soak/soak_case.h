// The soak's cases: each a pure function of the seed and its index, whatever else runs.
#pragma once

#include <cstdint>
#include <vector>

#include "support/pairs/random_pair.h"

namespace dgd_soak {

/// An unordered pair of types, the first not after the second.
struct TypePair {
  dgd_test::SetType type_1, type_2;

  int Dimension() const { return dgd_test::InfoOf(type_1).dimension; }
  bool IsCurved() const { return dgd_test::InfoOf(type_1).is_curved || dgd_test::InfoOf(type_2).is_curved; }
};

/// All of one dimension; case i is of the pair i modulo their number, in either order.
const std::vector<TypePair>& AllTypePairs();

/// After the first, unless asked otherwise.
inline constexpr int kMotionFrames = 5;
/// Between frames: of the extent, and in radians.
inline constexpr double kMotion = 0.01;

struct SoakCase {
  std::int64_t index;
  std::size_t type_pair;  ///< Of AllTypePairs().
  dgd_test::Placement placement;
  dgd_test::PairNumbers pair;
  /// Known from the construction; 0 if not.
  double growth_distance;
  /// Set 2's poses in the frames after the first.
  std::vector<dgd_test::PoseNumbers> motion;
};

/// @param frames  After the first; the first few are the same for any number of them.
SoakCase MakeCase(std::uint64_t seed, std::int64_t index, int frames = kMotionFrames);

}  // namespace dgd_soak
