// Time of work that lasts less than the clock can tell.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

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

/// Several methods in turns, for as many rounds: the least that each one took. What the machine does beside falls on
/// all of them alike.
/// @param time  Called with a method's index, returns its time; NaN, which it then stays, for one without.
template <class Time>
std::vector<double> LeastOfRounds(int rounds, std::size_t methods, const Time& time) {
  std::vector<double> least(methods);
  for (std::size_t m = 0; m < methods; ++m) least[m] = time(m);
  for (int round = 1; round < rounds; ++round) {
    for (std::size_t m = 0; m < methods; ++m) least[m] = std::min(least[m], time(m));
  }
  return least;
}

}  // namespace dgd_bench
