// The catalogue of hard cases: pairs of sets made to break a solver, by class, each with what makes it hard. The same
// cases are asked of the solver by the tests (tests/hard/) and of several methods by the benchmark (bench/hard_cases).
#pragma once

#include <cstdint>
#include <span>

#include "support/pairs/set_numbers.h"
#include "support/random.h"

namespace dgd_test {

/// What the construction of a case tells about it.
enum class Side {
  kUnknown,
  kApart,
  kTouching,  ///< Up to the rounding of the poses.
  kOverlapping,
};

struct HardCase {
  PairNumbers pair;
  Side side = Side::kUnknown;
};

struct HardClass {
  const char* name;  ///< On command lines and in tables.
  const char* why;   ///< What makes it hard.
  /// Case number `index` of the class: fixed combinations (types, features) go by the index, the rest is random.
  HardCase (*draw)(Random& random, int index);
  /// The rotations are this far from orthonormal, and so the sets from rigid: what that makes of an answer is no error.
  double pose_error = 0;
  /// Share of the cases that must be certified, in double and in float; the others may be declined, with a reason.
  double least_certified = 1, least_certified_float = 1;
};

std::span<const HardClass> AllHardClasses();

/// A pure function of the class, the seed and the index.
HardCase MakeHardCase(const HardClass& hard_class, std::uint64_t seed, int index);

}  // namespace dgd_test
