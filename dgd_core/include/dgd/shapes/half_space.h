// A half-space: the ground. Not a ConvexCore, since it has no end.
#pragma once

#include <algorithm>

#include "dgd/types.h"

namespace dgd {

/// All points of its own frame whose last coordinate is 0 or less: up is the last axis (z, in the plane y). Its centre
/// is the origin, on the border, so that growing about it leaves it as it is.
template <class S, int L = 3>
class HalfSpace {
 public:
  using Scalar = S;

  Vector<S, L> Center() const { return Vector<S, L>::Zero(); }
  /// The outward unit normal of the border.
  Vector<S, L> Normal() const { return Vector<S, L>::Unit(L - 1); }

  /// Distance of `point` to the set, metres; 0 inside.
  S Distance(const Vector<S, L>& point) const { return std::max(point[L - 1], S(0)); }
};

/// A half-plane.
template <class S>
using HalfPlane = HalfSpace<S, 2>;

}  // namespace dgd
