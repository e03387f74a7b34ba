#include "report/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace dgd_demos {
namespace {

constexpr int kWidth = 40;  // Characters.
constexpr std::chrono::milliseconds kPeriod{100};

// "1:05:30", "5:30"; empty while there is no estimate.
std::string TimeLeft(double elapsed, double share) {
  constexpr double kLeastShare = 0.01, kLeastElapsed = 2;  // s
  if (share < kLeastShare || elapsed < kLeastElapsed) return "";
  const long seconds = std::lround(elapsed * (1 - share) / share);
  char text[32];
  if (seconds < 3600) {
    std::snprintf(text, sizeof text, ", %ld:%02ld left", seconds / 60, seconds % 60);
  } else {
    std::snprintf(text, sizeof text, ", %ld:%02ld:%02ld left", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }
  return text;
}

}  // namespace

ProgressBar::ProgressBar(std::string label, double end)
    : label_(std::move(label)), end_(end), is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  constexpr const char* kCarriageReturnAndEraseLine = "\r\x1b[K";
  if (is_terminal_) std::fputs(kCarriageReturnAndEraseLine, stderr);
}

void ProgressBar::Update(double value) {
  if (!is_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_drawn_ < kPeriod) return;
  last_drawn_ = now;

  const double share = std::clamp(value / end_, 0.0, 1.0);
  const int filled = static_cast<int>(share * kWidth);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  std::fprintf(stderr, "\r%s [%s] %3.0f %%%s\x1b[K", label_.c_str(), bar.c_str(), 100 * share,
               TimeLeft(elapsed, share).c_str());
  std::fflush(stderr);
}

}  // namespace dgd_demos
