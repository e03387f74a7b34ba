#include "fallback.h"

#include <cstdio>

#include "dgd/assert.h"
#include "shape_type_name.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

struct Description {
  std::uint64_t FallbackCounts::*count;
  const char *outcome, *reason, *counter;
};

/// Descriptions in the order of Fallback.
constexpr std::array<Description, kFallbacks> kDescriptions{{
    {&FallbackCounts::fallbacks_not_converged, "was left to Bullet's GJK/EPA", "the growth distance did not converge",
     "fallbacks_not_converged"},
    {&FallbackCounts::fallbacks_no_interior, "was left to Bullet's GJK/EPA",
     "both are flat, and their distance did not converge", "fallbacks_no_interior"},
    {&FallbackCounts::fallbacks_invalid, "has no contacts", "a pose or a shape is not finite, or a shape has no points",
     "fallbacks_invalid"},
    {&FallbackCounts::fallbacks_no_memory, "has no contacts", "no memory is left, on the heap or in Bullet's pools",
     "fallbacks_no_memory"},
}};

const Description& DescriptionOf(Fallback fallback) {
  const auto index = static_cast<std::size_t>(fallback);
  DGD_ASSERT(index < kFallbacks);
  return kDescriptions[index];
}

const char* NameOrOther(int type) {
  const char* name = ShapeTypeName(type);
  return name != nullptr ? name : "OTHER";
}

}  // namespace

Fallback FallbackOf(dgd::Status status) {
  switch (status) {
    case dgd::Status::kInvalidInput:
      return Fallback::kInvalid;
    case dgd::Status::kNoInterior:
      return Fallback::kNoInterior;
    default:
      return Fallback::kNotConverged;
  }
}

std::uint64_t& CountOf(FallbackCounts& counts, Fallback fallback) { return counts.*DescriptionOf(fallback).count; }

FallbackMessage Describe(Fallback fallback, int type_0, int type_1) {
  const Description& words = DescriptionOf(fallback);
  FallbackMessage message{};
  std::snprintf(message.data(), message.size(),
                "dgd_bullet: a pair of %s and %s %s: %s. Reported once; counted in Statistics::%s.",
                NameOrOther(type_0), NameOrOther(type_1), words.outcome, words.reason, words.counter);
  return message;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
