// Counters of a narrowphase since it was made. Reading them while other threads dispatch gives a value each counter
// had at some moment; together they need not add up then.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Calls that the growth distance did not solve, by reason. The first two are handed to Bullet's GJK/EPA.
struct FallbackCounts {
  std::uint64_t fallbacks_not_converged = 0;  ///< Iteration limit, or bounds that rounding kept apart.
  std::uint64_t fallbacks_no_interior = 0;    ///< Two flat shapes without margins whose distance did not converge.
  std::uint64_t fallbacks_invalid = 0;    ///< NaN or infinity in a pose or a shape: no contacts, from Bullet neither.
  std::uint64_t fallbacks_no_memory = 0;  ///< For a hull, or in Bullet's pools: no contacts until the next try.

  std::uint64_t Fallbacks() const {
    return fallbacks_not_converged + fallbacks_no_interior + fallbacks_invalid + fallbacks_no_memory;
  }
};

/// How the calls of two types of shapes ended, a static plane among them.
struct PairStatistics : FallbackCounts {
  /// Bullet's numbers of the types (BOX_SHAPE_PROXYTYPE ...), type_0 <= type_1.
  int type_0 = 0, type_1 = 0;

  std::uint64_t calls = 0;      ///< Calls of processCollision(): the sum of the next three and the fallbacks.
  std::uint64_t separated = 0;  ///< Early exits: proven to be apart by more than the query's distance.
  std::uint64_t resting = 0;    ///< Nothing had moved, or all together: the contacts were recycled.
  std::uint64_t solved = 0;     ///< Solved by the growth distance.
  std::uint64_t deep = 0;       ///< Those of `solved` whose overlap is so deep that the least translation decided.

  /// All calls but the fallbacks by evaluations of the support functions up to the growth distance: index i counts the
  /// calls with i of them, the last one those with as many or more.
  static constexpr std::size_t kMaxIterations = 31;
  std::array<std::uint64_t, kMaxIterations + 1> iterations{};
  /// Largest relative gap between the bounds, upper_bound / lower_bound - 1, of what was solved.
  double worst_gap = 0;

  /// The same calls by contact points handed over in the step: none to four.
  std::array<std::uint64_t, 5> patch_sizes{};
};

/// The fallbacks are always counted: they are rare.
struct Statistics : FallbackCounts {
  std::vector<PairStatistics> pairs;  ///< An entry for each two types that met, with Options::count_pairs.
};

/// The statistics as a JSON object with the members' names; types are named as Bullet names them, without
/// "_SHAPE_PROXYTYPE".
DGD_BULLET_EXPORT std::string ToJson(const Statistics& statistics);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
