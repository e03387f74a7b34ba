#include "soak/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace dgd_soak {
namespace {

constexpr int kWidth = 30;  // Characters.
constexpr std::chrono::milliseconds kTerminalPeriod{200};
constexpr std::chrono::seconds kLogPeriod{60};

}  // namespace

Progress::Progress(std::int64_t first, std::int64_t end)
    : first_(first), end_(end), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { Clear(); }

void Progress::Clear() const {
  constexpr const char* kCarriageReturnAndEraseLine = "\r\x1b[K";
  if (is_terminal_) std::fputs(kCarriageReturnAndEraseLine, stderr);
}

void Progress::Update(std::int64_t done, std::size_t failures) {
  const auto now = Clock::now();
  if (now - last_drawn_ < (is_terminal_ ? Clock::duration(kTerminalPeriod) : Clock::duration(kLogPeriod))) return;
  last_drawn_ = now;

  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done - first_) / seconds;
  const auto left = rate > 0 ? static_cast<long long>(static_cast<double>(end_ - done) / rate) : 0;
  const double share = std::clamp(static_cast<double>(done) / static_cast<double>(end_), 0.0, 1.0);
  const int filled = static_cast<int>(share * kWidth);
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(kWidth - filled), '.');
  std::fprintf(stderr, "%s[%s] %5.1f %%, %lld of %lld pairs, %.0f/s, %lld:%02lld:%02lld left%s%s",
               is_terminal_ ? "\r\x1b[K" : "", bar.c_str(), 100 * share, static_cast<long long>(done),
               static_cast<long long>(end_), rate, left / 3600, left / 60 % 60, left % 60,
               failures > 0 ? ", with failures" : "", is_terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace dgd_soak
