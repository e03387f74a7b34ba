// When to hand what was written to the operating system: often enough that a crash loses a tenth of a second of a run,
// seldom enough that it costs nothing.
#pragma once

#include <chrono>

namespace dgd_demos {

class FlushTimer {
 public:
  /// Whether a tenth of a second has passed since this was last true, or since construction.
  bool IsDue() {
    const Clock::time_point now = Clock::now();
    if (now - last_ < kInterval) return false;
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kInterval{100};

  Clock::time_point last_ = Clock::now();
};

}  // namespace dgd_demos
