// How one call of a pair ended.
#pragma once

#include <cstdint>
#include <optional>

#include "dgd_bullet/linkage.h"
#include "fallback.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Small enough to be returned in registers, stage by stage.
struct PairOutcome {
  /// The stage that ended the call.
  enum class Stage : std::uint8_t {
    kSeparated,  ///< A separating axis, or a bound of the distance, shows that there are no contacts.
    kRecycled,   ///< The last step's contacts are valid.
    kDeep,       ///< The growth distance was solved, and the least translation of bodies so deep in each other.
    kSolved,     ///< The growth distance was solved.
  };

  double gap = 0;  ///< Relative gap between the bounds of the growth distance, if that was solved.
  int iterations = 0;
  std::uint8_t patch_size = 0;
  Stage stage = Stage::kSolved;
  std::optional<Fallback> fallback = std::nullopt;  ///< Why there is no result; the other members are unused then.
};
static_assert(sizeof(PairOutcome) <= 16);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
