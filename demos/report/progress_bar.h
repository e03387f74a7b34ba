// A progress bar on standard error, for people only: nothing at all if that is a file or a pipe.
#pragma once

#include <chrono>
#include <string>

namespace dgd_demos {

class ProgressBar {
 public:
  /// @param label  stands before the bar.
  ProgressBar(std::string label, double end);
  /// Wipes the bar: what is printed next starts on a clean line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param value  from 0 to the end; draws at most a few times a second.
  void Update(double value);

 private:
  std::string label_;
  double end_;
  bool is_terminal_;
  std::chrono::steady_clock::time_point last_drawn_{};
};

}  // namespace dgd_demos
