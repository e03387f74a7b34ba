// How large a set is, by its support function alone.
#pragma once

#include "dgd/convex_set.h"

namespace dgd_test {

/// The diagonal of the core's axis-aligned bounding box in its own frame, and twice the radius; metres.
template <class Core>
double Extent(const Core& core, double radius) {
  constexpr int L = dgd::kDimension<Core>;
  dgd::Vector<double, L> diagonal;
  for (int axis = 0; axis < L; ++axis) {
    const auto up = dgd::VectorOf<Core>::Unit(axis);
    diagonal[axis] = double(core.Support(up).point[axis] - core.Support(-up).point[axis]);
  }
  return diagonal.norm() + 2 * radius;
}

}  // namespace dgd_test
