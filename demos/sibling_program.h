// headless_sim for the other precision of Bullet, which is a program of its own.
#pragma once

#include <string>
#include <vector>

namespace dgd_demos {

/// This program, or its sibling in the same folder that is built for the other precision.
/// @param precision  "float" or "double".
/// @throws std::runtime_error if it does not exist.
std::string ProgramFor(const std::string& precision);

/// Runs a program with this one's streams until it ends, and passes stop signals on to it; see StopSignals.
/// @return its exit status, or 128 and the number of the signal that ended it, as in shells.
/// @throws std::runtime_error if it cannot be started.
int RunAndWait(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace dgd_demos
