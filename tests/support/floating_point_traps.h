// Floating-point exceptions as errors: what is not a number, infinite or too large ends the process where it arises,
// not where somebody looks at the answer.
#pragma once

#include <cfenv>

namespace dgd_test {

/// Traps invalid operations, divisions by zero and overflow from its construction to its end, on this thread; before,
/// exceptions may have been raised. glibc on x86-64.
class FloatingPointTraps {
 public:
  FloatingPointTraps() {
    std::fegetenv(&before_);
    std::feclearexcept(kTrapped);
    feenableexcept(kTrapped);
  }
  ~FloatingPointTraps() {
    std::feclearexcept(kTrapped);
    std::fesetenv(&before_);
  }
  FloatingPointTraps(const FloatingPointTraps&) = delete;
  FloatingPointTraps& operator=(const FloatingPointTraps&) = delete;

 private:
  static constexpr int kTrapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  std::fenv_t before_{};
};

}  // namespace dgd_test
