#include "algorithms/fallback.h"

#include <cstdio>

#include "shapes/shape_type_name.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

struct Words {
  const char* outcome;
  const char* reason;
  const char* counter;
};

Words WordsFor(Fallback fallback) {
  switch (fallback) {
    case Fallback::kNotConverged:
      return {"was left to Bullet's GJK/EPA", "the growth distance did not converge", "fallbacks_not_converged"};
    case Fallback::kNoInterior:
      return {"was left to Bullet's GJK/EPA", "both are flat and without a margin", "fallbacks_no_interior"};
    case Fallback::kInvalid:
      return {"has no contacts", "a pose or a shape is not finite, or a shape has no points", "fallbacks_invalid"};
    case Fallback::kNoMemory:
      break;
  }
  return {"has no contacts", "no memory is left, on the heap or in Bullet's pools", "fallbacks_no_memory"};
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

std::uint64_t& CountOf(FallbackCounts& counts, Fallback fallback) {
  switch (fallback) {
    case Fallback::kNotConverged:
      return counts.fallbacks_not_converged;
    case Fallback::kNoInterior:
      return counts.fallbacks_no_interior;
    case Fallback::kInvalid:
      return counts.fallbacks_invalid;
    case Fallback::kNoMemory:
      break;
  }
  return counts.fallbacks_no_memory;
}

FallbackMessage Describe(Fallback fallback, int type_0, int type_1) {
  const Words words = WordsFor(fallback);
  FallbackMessage message{};
  std::snprintf(message.data(), message.size(),
                "dgd_bullet: a pair of %s and %s %s: %s. Told once; counted in Statistics::%s.", NameOrOther(type_0),
                NameOrOther(type_1), words.outcome, words.reason, words.counter);
  return message;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
