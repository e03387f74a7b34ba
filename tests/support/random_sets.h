// Random sets and pairs of every core type, the same on every machine for the same seed.
#pragma once

#include "support/random.h"
#include "support/reference_set.h"

namespace dgd_test {

/// Two decades: every length of a set is log-uniform between these, so one set may be a hundred times longer than
/// thick.
inline constexpr double kSmallest = 0.05, kLargest = 5;

/// @param rounded  With a radius from the same two decades, else radius 0.
ReferenceSet RandomSet(Random& random, CoreType type, bool rounded);

/// Hull of `count` points near a sphere of the given diameter: the hulls of PEERS.md.
ReferenceSet RandomHull(Random& random, int count, double diameter, double radius);

/// Where set 2 stands in relation to set 1.
struct Nearness {
  /// Log-uniform bounds on the distance of the sets' middles, relative to an estimate of where they touch.
  double closest = 0.02, farthest = 10;
};

/// Random poses, set 2 placed from deep inside set 1 to far away, about as often hitting as missing.
void PlaceRandomly(Random& random, ReferencePair& pair, const Nearness& nearness = {});

/// A random pair of these types in random poses. At least one of the sets has an interior: if neither core has,
/// and neither is asked to be rounded, set 1 gets a radius.
ReferencePair RandomPair(Random& random, CoreType type_1, bool rounded_1, CoreType type_2, bool rounded_2);

/// The same two sets, relatively moved by `amount` of the pair's extent and as many radians.
ReferencePair Moved(Random& random, const ReferencePair& pair, double amount);

}  // namespace dgd_test
