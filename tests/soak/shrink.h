// A failing case, made simpler as long as it fails: until it is one to think about.
#pragma once

#include <functional>

#include "soak/soak_case.h"

namespace dgd_soak {

/// Whether a case fails, in the way that is looked for.
using Fails = std::function<bool(const SoakCase&)>;

/// Leaves out frames, points, radii and rotations, and rounds numbers to a few digits, one change after the other, and
/// keeps those after which the case still fails. Ends where none of them is left; what it says of the growth distance
/// that is known from the construction goes with the first change.
/// @param fails  Of candidates that a set refuses (std::invalid_argument), too: those do not.
SoakCase Shrink(SoakCase failing, const Fails& fails);

}  // namespace dgd_soak
