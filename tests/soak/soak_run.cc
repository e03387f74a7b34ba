#include "soak/soak_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "soak/progress.h"

namespace dgd_soak {
namespace {

using dgd_test::Tally;

// Of cases that one thread takes at once: some ten milliseconds.
constexpr std::int64_t kBlock = 128;
constexpr std::chrono::seconds kSavePeriod{10};
constexpr std::size_t kMaxPrinted = 5;

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

/// The indices of the cases whose types the options choose, by their place among these.
class ChosenCases {
 public:
  explicit ChosenCases(const std::vector<dgd_test::SetType>& types) {
    const auto is_chosen = [&](dgd_test::SetType type) { return types.empty() || std::ranges::count(types, type) > 0; };
    for (std::size_t i = 0; i < AllTypePairs().size(); ++i) {
      if (is_chosen(AllTypePairs()[i].type_1) && is_chosen(AllTypePairs()[i].type_2)) {
        type_pairs_.push_back(static_cast<std::int64_t>(i));
      }
    }
  }

  std::int64_t Index(std::int64_t place) const {
    const auto chosen = static_cast<std::int64_t>(type_pairs_.size());
    return place / chosen * static_cast<std::int64_t>(AllTypePairs().size()) +
           type_pairs_[static_cast<std::size_t>(place % chosen)];
  }

 private:
  std::vector<std::int64_t> type_pairs_;
};

/// A block's part of the state, and what is to be printed of it.
struct BlockResult {
  SoakState state;
  std::vector<std::string> complaints = {};
};

template <class S>
std::string ComplaintsIn(const char* scalar, const SoakCase& soak_case, const Query& query, Tally& tally) {
  const std::string complaints = Examine<S>(soak_case, query, tally);
  return complaints.empty() ? "" : std::string(scalar) + "\n" + complaints;
}

/// One case in the chosen scalars; an exception is a complaint, too.
std::string ExamineCase(const SoakOptions& options, std::int64_t index, SoakState& state) {
  std::string complaints;
  try {
    const SoakCase soak_case = MakeCase(options.seed, index, options.frames);
    const std::size_t i = soak_case.type_pair;
    if (options.in_double) complaints += ComplaintsIn<double>("double", soak_case, options.query, state.in_double[i]);
    if (options.in_float) complaints += ComplaintsIn<float>("float", soak_case, options.query, state.in_float[i]);
    if (complaints.empty()) return "";
    complaints = std::string("placement ") + NameOf(soak_case.placement) + "\n" + Dump(soak_case.pair) + complaints;
  } catch (const std::exception& error) {
    complaints += std::string("exception: ") + error.what() + "\n";
  }
  return "FAILED: dgd_soak " + options.CaseOptions() + " --replay " + std::to_string(index) + "\n" + complaints;
}

/// Threads that take blocks in turn; their results are handed out in the order of the blocks.
class Workers {
 public:
  Workers(const SoakOptions& options, std::int64_t first)
      : options_(options), cases_(options.types), next_block_(first), next_result_(first) {
    for (int i = 0; i < options.threads; ++i) threads_.emplace_back([this] { Work(); });
  }

  /// Waits for the next block's result; null if there are no more, or the run was stopped.
  std::unique_ptr<BlockResult> Next() {
    std::unique_lock lock(mutex_);
    for (;;) {
      if (const auto result = results_.find(next_result_); result != results_.end()) {
        auto next = std::move(result->second);
        next_result_ += next->state.done;
        results_.erase(result);
        return next;
      }
      if (busy_ == 0) return nullptr;
      changed_.wait(lock);
    }
  }

 private:
  void Work() {
    for (;;) {
      const std::int64_t first = next_block_.fetch_add(kBlock);
      if (first >= options_.pairs || stop_requested) break;
      auto result = std::make_unique<BlockResult>(BlockResult{SoakState(options_.CaseOptions())});
      const std::int64_t end = std::min(first + kBlock, options_.pairs);
      for (std::int64_t place = first; place < end; ++place) ExamineInto(cases_.Index(place), *result);
      result->state.done = end - first;
      const std::lock_guard lock(mutex_);
      results_[first] = std::move(result);
      changed_.notify_all();
    }
    const std::lock_guard lock(mutex_);
    --busy_;
    changed_.notify_all();
  }

  void ExamineInto(std::int64_t index, BlockResult& result) const {
    std::string complaints = ExamineCase(options_, index, result.state);
    if (complaints.empty()) return;
    if (result.state.failures.size() < SoakState::kMaxFailures) result.state.failures.push_back(index);
    if (result.complaints.size() < kMaxPrinted) result.complaints.push_back(std::move(complaints));
  }

  const SoakOptions& options_;
  const ChosenCases cases_;
  std::atomic<std::int64_t> next_block_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by the mutex.
  std::int64_t next_result_;
  int busy_ = options_.threads;
  std::map<std::int64_t, std::unique_ptr<BlockResult>> results_;
  // Last, so that they end before what they use.
  std::vector<std::jthread> threads_;
};

}  // namespace

void RequestStop() { stop_requested = true; }

bool RunSoak(const SoakOptions& options, SoakState& state) {
  Progress progress(state.done, options.pairs);
  std::size_t printed = state.failures.size();
  auto last_saved = std::chrono::steady_clock::now();
  Workers workers(options, state.done);
  while (const auto block = workers.Next()) {
    state.Merge(block->state);
    for (const std::string& complaint : block->complaints) {
      if (printed++ >= kMaxPrinted) break;
      progress.Clear();
      std::fputs(complaint.c_str(), stderr);
    }
    progress.Update(state.done, state.failures.size());
    const auto now = std::chrono::steady_clock::now();
    if (!options.state.empty() && now - last_saved >= kSavePeriod) {
      Save(state, options.state);
      last_saved = now;
    }
  }
  if (!options.state.empty()) Save(state, options.state);
  return state.done >= options.pairs;
}

}  // namespace dgd_soak
