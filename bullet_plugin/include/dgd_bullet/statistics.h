// Counters of a narrowphase since it was made. Reading them while other threads dispatch gives a value each counter
// had at some moment; together they need not add up then.
#pragma once

#include <cstdint>

namespace dgd_bullet {

/// Pairs handed to Bullet's GJK/EPA, by reason. Only these rare events are counted, so counting costs nothing.
struct Statistics {
  std::uint64_t fallbacks_not_converged = 0;  ///< Iteration limit, or bounds that rounding kept apart.
  std::uint64_t fallbacks_no_interior = 0;    ///< Two flat shapes without margins: no growth distance exists.
  std::uint64_t fallbacks_invalid = 0;  ///< NaN or infinity in a pose or a shape: no contacts, from Bullet neither.

  std::uint64_t Fallbacks() const { return fallbacks_not_converged + fallbacks_no_interior + fallbacks_invalid; }
};

}  // namespace dgd_bullet
