#include "stop_signals.h"

namespace dgd_demos {
namespace {

volatile std::sig_atomic_t is_stop_requested = 0;

}  // namespace

StopSignals::StopSignals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { is_stop_requested = 1; };
  sigaction(SIGINT, &action, &interrupt_before_);
  sigaction(SIGTERM, &action, &terminate_before_);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool IsStopRequested() { return is_stop_requested != 0; }

}  // namespace dgd_demos
