#include "stop_signals.h"

#include <csignal>

namespace dgd_demos {
namespace {

volatile std::sig_atomic_t is_stop_requested = 0;

}  // namespace

void CatchStopSignals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { is_stop_requested = 1; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool IsStopRequested() { return is_stop_requested != 0; }

}  // namespace dgd_demos
