// Ctrl-C and SIGTERM as requests: the program finishes its current step and leaves complete files.
#pragma once

namespace dgd_demos {

/// From here on, SIGINT and SIGTERM interrupt system calls and are noted, in place of ending the program. Programs that
/// it starts are ended by them as before.
void CatchStopSignals();

/// Whether such a signal has come since.
bool IsStopRequested();

}  // namespace dgd_demos
