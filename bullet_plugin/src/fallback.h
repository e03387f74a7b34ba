// Why a call was not solved by the growth distance, and the message about it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "dgd/query_types.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/statistics.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The members of FallbackCounts, in their order.
enum class Fallback : std::uint8_t { kNotConverged, kNoInterior, kInvalid, kNoMemory };
inline constexpr std::size_t kFallbacks = 4;

/// The reason of a query whose result is not certified.
Fallback FallbackOf(dgd::Status status);

/// Whether Bullet's own algorithm has a result where the solver has none.
constexpr bool IsSolvedByBullet(Fallback fallback) {
  return fallback == Fallback::kNotConverged || fallback == Fallback::kNoInterior;
}

/// The counter of a reason.
std::uint64_t& CountOf(FallbackCounts& counts, Fallback fallback);

/// One line for a log, ended by 0, without a line's end.
using FallbackMessage = std::array<char, 256>;

/// What happened to a pair of two of Bullet's types of shapes. Allocates nothing, since memory may be what is missing.
FallbackMessage Describe(Fallback fallback, int type_0, int type_1);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
