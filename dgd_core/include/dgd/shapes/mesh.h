// A polytope whose support points are found by walking along its edges, however few they are.
#pragma once

#include "dgd/shapes/polytope.h"

namespace dgd {

/// Polytope does so by itself from kMostScannedVertices on.
template <class S>
using Mesh = Polytope<S, 0>;

}  // namespace dgd
