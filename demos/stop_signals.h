// Ctrl-C and SIGTERM as requests: the program finishes its current step and leaves complete files.
#pragma once

#include <csignal>

namespace dgd_demos {

/// While it exists, SIGINT and SIGTERM interrupt system calls and are noted, in place of ending the program. Programs
/// that it starts are ended by them as before.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

 private:
  struct sigaction interrupt_before_, terminate_before_;
};

/// Whether such a signal has come while one existed.
bool IsStopRequested();

}  // namespace dgd_demos
