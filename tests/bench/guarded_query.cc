#include "bench/guarded_query.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "bench/stopwatch.h"

namespace dgd_bench {
namespace {

/// What a child tells its parent: plain bytes, less than a pipe takes at once.
struct Message {
  bool has_distance;
  double distance, normal[3], microseconds;
};

Message MessageOf(const TimedAnswer& timed) {
  const HardAnswer& answer = timed.answer;
  const Eigen::Vector3d& n = answer.normal;
  return {answer.distance.has_value(), answer.distance.value_or(0), {n.x(), n.y(), n.z()}, timed.microseconds};
}

/// Ends here; without what the parent has to clean up.
[[noreturn]] void Work(const HardQuery& query, int rounds, int pipe_end) {
  // A failed assertion speaks there, in the middle of the table.
  if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
  const Message message = MessageOf(AskAndTime(query, rounds));
  const bool is_written = write(pipe_end, &message, sizeof message) == sizeof message;
  _exit(is_written ? 0 : 1);
}

TimedAnswer Failed(const char* reason, std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
  TimedAnswer failed;
  failed.answer.reason = reason;
  failed.microseconds = elapsed.count();
  return failed;
}

}  // namespace

TimedAnswer AskAndTime(const HardQuery& query, int rounds) {
  TimedAnswer timed;
  timed.microseconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    timed.microseconds = std::min(timed.microseconds, MeanMicroseconds(1, [&] { timed.answer = query.Ask(); }));
  }
  return timed;
}

TimedAnswer AskInChild(const HardQuery& query, int rounds, std::chrono::milliseconds patience) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe to a child process");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a child process");
  if (child == 0) Work(query, rounds, ends[1]);
  close(ends[1]);

  // A child that dies closes its end, and wakes us as well.
  pollfd readable{ends[0], POLLIN, 0};
  const bool is_awake = poll(&readable, 1, static_cast<int>(patience.count())) > 0;
  Message message{};
  const bool is_complete = is_awake && read(ends[0], &message, sizeof message) == sizeof message;
  if (!is_complete) kill(child, SIGKILL);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!is_complete) return Failed(is_awake ? "crashed" : "does not end", start);

  TimedAnswer timed;
  if (message.has_distance) timed.answer.distance = message.distance;
  timed.answer.normal = Eigen::Vector3d(message.normal[0], message.normal[1], message.normal[2]);
  timed.microseconds = message.microseconds;
  return timed;
}

}  // namespace dgd_bench
