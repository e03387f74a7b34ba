#include "bench/guarded_peer.h"

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
  bool is_answered;
  double separation, normal[3], witness_1[3], witness_2[3], microseconds;
};

Message MessageOf(const TimedAnswer& timed) {
  Message message{};
  message.microseconds = timed.microseconds;
  message.is_answered = timed.answer.has_value();
  if (!message.is_answered) return message;
  message.separation = timed.answer->separation;
  Eigen::Vector3d::Map(message.normal) = timed.answer->normal;
  Eigen::Vector3d::Map(message.witness_1) = timed.answer->witness_1;
  Eigen::Vector3d::Map(message.witness_2) = timed.answer->witness_2;
  return message;
}

TimedAnswer TimedAnswerOf(const Message& message) {
  TimedAnswer timed;
  timed.microseconds = message.microseconds;
  if (message.is_answered) {
    timed.answer = SeparationAnswer{Eigen::Vector3d::Map(message.normal), message.separation,
                                    Eigen::Vector3d::Map(message.witness_1), Eigen::Vector3d::Map(message.witness_2)};
  }
  return timed;
}

/// Ends here; without what the parent has to clean up.
[[noreturn]] void Work(const Peer& peer, int rounds, int pipe_end) {
  // A failed assertion speaks there, in the middle of the table.
  if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
  const Message message = MessageOf(AskAndTime(peer, rounds));
  const bool is_written = write(pipe_end, &message, sizeof message) == sizeof message;
  _exit(is_written ? 0 : 1);
}

TimedAnswer Failed(const char* reason, std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
  TimedAnswer failed;
  failed.reason = reason;
  failed.microseconds = elapsed.count();
  return failed;
}

}  // namespace

TimedAnswer AskAndTime(const Peer& peer, int rounds) {
  TimedAnswer timed;
  timed.microseconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    timed.microseconds = std::min(timed.microseconds, MeanMicroseconds(1, [&] { timed.answer = peer.Ask(); }));
  }
  return timed;
}

TimedAnswer AskInChild(const Peer& peer, int rounds, std::chrono::milliseconds patience) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe to a child process");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a child process");
  if (child == 0) Work(peer, rounds, ends[1]);
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

  return TimedAnswerOf(message);
}

}  // namespace dgd_bench
