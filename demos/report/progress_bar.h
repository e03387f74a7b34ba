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

  /// Draws the bar and an estimate of the time left, at most a few times a second.
  /// @param value  from 0 to the end.
  void Update(double value);

 private:
  std::string label_;
  double end_;
  bool is_terminal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), last_drawn_{};
};

}  // namespace dgd_demos
