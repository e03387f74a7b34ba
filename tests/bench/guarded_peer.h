// Other people's code in a process of its own: where it never returns, or crashes, that is an answer too.
#pragma once

#include <chrono>
#include <optional>

#include "bench/peers/peer.h"

namespace dgd_bench {

struct TimedAnswer {
  std::optional<SeparationAnswer> answer;
  double microseconds = 0;  ///< The least of the rounds.
  const char* reason = "";  ///< Why there is no answer, where the process tells more than the peer does.
};

/// @param rounds  Times that the peer is asked.
TimedAnswer AskAndTime(const Peer& peer, int rounds);

/// The same in a child process. One that does not end within `patience`, or ends otherwise than by an answer, has none,
/// and the reason says so; its time is then as long as that took.
/// @throws std::runtime_error if there can be no process.
TimedAnswer AskInChild(const Peer& peer, int rounds, std::chrono::milliseconds patience);

}  // namespace dgd_bench
