// Work in a child process with limits of time and memory: where it crashes, hangs or grows without end, this process
// gets a sentence.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace dgd_demos {

struct ChildLimits {
  unsigned processor_time;  ///< s
  unsigned wall_time;       ///< s, for work that waits, as for a file system that does not respond.
  std::uint64_t memory;     ///< Bytes, in addition to those that this process has.
};

/// Calls `work` in a child of this process, whose memory is a copy and whose output goes nowhere. The child ends with
/// the calling thread, by whatever that is ended; other threads are not in it, so that `work` may need none of their
/// locks (that of the heap is free).
/// @param name  begins the sentence about a child that fails: "its import".
/// @return what `work` returned.
/// @throws std::runtime_error with the message that `work` threw, or with how the child ended without one.
std::string RunInChild(const std::string& name, const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace dgd_demos
