#include "dispatch/thread_team.h"

#include <cstddef>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

ThreadTeam::ThreadTeam(int threads) : start_(threads), end_(threads) {
  DGD_ASSERT(threads >= 1);
  const auto helpers = static_cast<std::size_t>(threads - 1);
  try {
    while (helpers_.size() < helpers) helpers_.emplace_back([this] { Help(); });
  } catch (...) {
    // Helpers that have been started wait for all.
    for (std::size_t missing = helpers - helpers_.size(); missing > 0; --missing) start_.arrive_and_drop();
    start_.arrive_and_wait();
    throw;
  }
}

ThreadTeam::~ThreadTeam() {
  work_ = nullptr;
  start_.arrive_and_wait();
}

void ThreadTeam::Run(const std::function<void()>& work) {
  work_ = &work;
  start_.arrive_and_wait();
  work();
  end_.arrive_and_wait();
}

void ThreadTeam::Help() {
  for (;;) {
    start_.arrive_and_wait();
    if (work_ == nullptr) return;
    (*work_)();
    end_.arrive_and_wait();
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
