// The normal that a query in the ray's frame begins with.
#pragma once

#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd {

/// The last one where there is one, a guess for curved sets, else along the ray (paper, Alg. 1). A guess takes longer
/// than it saves in the plane, and for polytopes.
/// @param warm_start  Or null.
/// @return unit length, ray frame, not downwards.
template <class Difference>
typename Difference::Point FirstNormal(const Difference& difference,
                                       const WarmStart<typename Difference::S, Difference::L>* warm_start) {
  using Point = typename Difference::Point;
  constexpr int L = Difference::L;
  if (warm_start != nullptr && HasNormal(*warm_start)) {
    // Scaled to unit length each time: the rotations' roundoff would add up over the frames.
    const Point normal = difference.DirectionToFrame(warm_start->normal_1).normalized();
    if (normal[L - 1] > 0) return normal;
  }
  if constexpr (Difference::kIsSmooth && L == 3) {
    return difference.EllipsoidGuess();
  }
  return Point::Unit(L - 1);
}

}  // namespace dgd
