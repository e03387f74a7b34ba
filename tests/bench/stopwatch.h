// Time of work that lasts less than the clock can tell.
#pragma once

#include <chrono>

namespace dgd_bench {

/// Makes the compiler believe that `value` is read, and that everything reachable may have changed since: neither can
/// it drop a query whose result nobody looks at, nor hoist one out of the loop that repeats it.
template <class T>
inline void Keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Mean over `repeats` calls in a row, in microseconds; `work` keeps its own results.
template <class Work>
double MeanMicroseconds(int repeats, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repeats; ++i) work();
  const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / repeats;
}

}  // namespace dgd_bench
