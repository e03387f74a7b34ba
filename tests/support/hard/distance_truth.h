// The signed distance of a pair, from its support functions alone.
#pragma once

#include <Eigen/Core>

#include "support/pairs/set_numbers.h"

namespace dgd_test {

/// Metres. The true signed distance is between `lower` and `upper`, both proven; equal up to rounding, but for flat
/// sets inside each other.
struct DistanceTruth {
  double lower = 0, upper = 0;
  double size = 0;   ///< Of both sets' extents.
  double reach = 0;  ///< The largest coordinate that a computation meets.
};

/// Of a pair of space. Shares no code with the solver but the sets' support functions, in double; any unit of length.
/// Throws std::invalid_argument for numbers that are no sets.
DistanceTruth TruthOf(const PairNumbers& pair);

/// Of the supporting planes along a unit vector from set 1 to set 2, metres.
double SeparationAlong(const PairNumbers& pair, const Eigen::Vector3d& normal);

}  // namespace dgd_test
