// Newton's method for the place on a line where two convex sets have a chosen signed distance.
#pragma once

#include <cmath>

namespace dgd_test {

/// The signed distance of two sets, one of which moves along a line: of a supporting plane between them.
struct DistanceOnLine {
  double value;  ///< Metres.
  double slope;  ///< Of `value` in the way along the line.
};

/// As a function of the translation, the signed distance of convex sets is convex: from outside, the method comes down
/// monotonically and cannot miss.
/// @param distance_at  Moves the sets to a place on the line, and returns their DistanceOnLine. Last called where the
///                     distance is `wanted`.
/// @param start, wanted, tolerance  Metres: where the sets are farther apart than `wanted`, which the distance found
///                                  misses by no more than `tolerance`.
/// @return false if the sets are that deep nowhere on the line, or the method has not converged.
template <class DistanceAt>
bool PlaceAtDistance(const DistanceAt& distance_at, double start, double wanted, double tolerance) {
  constexpr int kMaxSteps = 60;
  double way = start;
  for (int step = 0; step < kMaxSteps; ++step) {
    const DistanceOnLine distance = distance_at(way);
    if (std::abs(distance.value - wanted) <= tolerance) return true;
    if (!(distance.slope > 0)) return false;
    way -= (distance.value - wanted) / distance.slope;
  }
  return false;
}

}  // namespace dgd_test
