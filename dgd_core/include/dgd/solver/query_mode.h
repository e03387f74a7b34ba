// The kinds of queries of two sets.
#pragma once

namespace dgd {

/// What ends a query besides convergence.
enum class QueryMode {
  kDistance,
  kCollision  ///< A common point, or a plane between the sets.
};

}  // namespace dgd
