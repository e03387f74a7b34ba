// The run over all cases: threads, progress, states saved on the way.
#pragma once

#include "soak/soak_options.h"
#include "soak/soak_state.h"

namespace dgd_soak {

/// Ends the run at the next moment at which its state is whole. May be called from a signal handler.
void RequestStop();

/// Examines the cases that the options choose from the state's on, and prints the first failing ones to standard
/// error, in order. Saves the state to the options' file, if any, now and then and at the end.
/// @return whether it came to the end.
bool RunSoak(const SoakOptions& options, SoakState& state);

}  // namespace dgd_soak
