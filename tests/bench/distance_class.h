// The classes of pairs by signed distance: what a narrowphase meets, from a broadphase's false alarm to a deep overlap.
#pragma once

#include <array>

namespace dgd_bench {

/// Pairs whose signed distance lies between two bounds; negative is the depth of an overlap.
struct DistanceClass {
  const char* key;    ///< In the CSV file.
  const char* title;  ///< In the table.
  double low, high;   ///< Metres.
};

/// The one list of classes. Touching pairs lie on both sides of contact, nearer to it than float tells apart there.
inline constexpr std::array kDistanceClasses = {
    DistanceClass{"separated", "separated, 2..30 cm", 0.02, 0.30},
    DistanceClass{"nearly_touching", "nearly touching, 0.1..10 mm", 1e-4, 1e-2},
    DistanceClass{"touching", "touching, within 1 um", -1e-6, 1e-6},
    DistanceClass{"shallow", "shallow, 0.1..10 mm deep", -1e-2, -1e-4},
    DistanceClass{"deep", "deep, 5..15 cm", -0.15, -0.05},
};

}  // namespace dgd_bench
