#include "report/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace dgd_demos {
namespace {

constexpr int kWidth = 40;  // Characters.
constexpr std::chrono::milliseconds kPeriod{100};

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
  std::fprintf(stderr, "\r%s [%s] %3.0f %%", label_.c_str(), bar.c_str(), 100 * share);
  std::fflush(stderr);
}

}  // namespace dgd_demos
