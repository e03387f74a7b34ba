// How far a long run is, on standard error: a bar with rate and time left on a terminal, else a line now and then.
#pragma once

#include <chrono>
#include <cstdint>

namespace dgd_soak {

class Progress {
 public:
  /// @param first  Where the run starts, of `end`.
  Progress(std::int64_t first, std::int64_t end);
  /// Wipes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param failures  Failing cases so far, as far as they are counted.
  void Update(std::int64_t done, std::size_t failures);
  /// Wipes the bar, so that something else may be printed.
  void Clear() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::int64_t first_, end_;
  bool is_terminal_;
  Clock::time_point start_ = Clock::now(), last_drawn_ = start_;
};

}  // namespace dgd_soak
