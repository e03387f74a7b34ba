// Random pairs of sets of all types as plain numbers, the same on every machine for the same seed.
#pragma once

#include "support/pairs/any_pair.h"
#include "support/pairs/set_numbers.h"
#include "support/random.h"

namespace dgd_test {

/// Every length log-uniform between these, metres.
struct LengthRange {
  double least, greatest;
};

SetNumbers RandomSetOf(Random& random, SetType type, const LengthRange& lengths, bool is_rounded);

/// Two sets of any types of space, not both without an interior; not yet placed.
PairNumbers RandomPairOfAnyTypes(Random& random, const LengthRange& lengths);

/// Uniform over all rotations of the dimension.
Eigen::Matrix3d RandomRotation(Random& random, int dimension);
/// In the plane, z = 0.
Eigen::Vector3d RandomUnitVector(Random& random, int dimension);

/// Where set 2 stands in relation to set 1.
enum class Placement {
  kGeneric,           ///< From deep inside to far away.
  kTouching,          ///< Two support points coincide: growth distance 1, up to rounding.
  kNearlyTouching,    ///< As before, but for one part in 10^3 to 10^15 of the way between the centres.
  kAligned,           ///< The same orientation, along the world's axes, and about touching along an axis.
  kAlongAxis,         ///< The centres on an axis of set 1.
  kNearlyCoincident,  ///< The centres nearly coincide.
  kFarApart,
};
inline constexpr int kPlacementCount = 7;
const char* NameOf(Placement placement);

/// Sets the poses. Set 1 stands away from the world's origin, by about its own size.
/// @return the growth distance if the placement decides it, else 0.
double Place(Random& random, Placement placement, PairNumbers& pair);

/// Set 2 moved relative to set 1, by `amount` of the pair's extent and as many radians about its frame's origin.
PoseNumbers MovedALittle(Random& random, const PoseNumbers& pose, int dimension, double amount, double extent);

}  // namespace dgd_test
