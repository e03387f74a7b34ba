// Threads that wait for work which all of them do at once.
#pragma once

#include <barrier>
#include <functional>
#include <thread>
#include <vector>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class ThreadTeam {
 public:
  /// @param threads  >= 1, the caller's among them.
  /// Throws std::system_error if a thread cannot be started.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls `work`, which must not throw, once on each thread, and returns when all calls have returned.
  void Run(const std::function<void()>& work);

 private:
  void Help();

  std::barrier<> start_, end_;
  const std::function<void()>* work_ = nullptr;  // Null ends the threads.
  std::vector<std::jthread> helpers_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
