// The exit statuses of the programs, as their --help lists them.
#pragma once

namespace dgd_demos {

enum ExitStatus {
  kSuccess = 0,
  kLostBody = 1,       ///< A body left the world, or a value was not finite.
  kNoPath = 1,         ///< Of plan_motion: there is none for a seed, or start or goal is in collision.
  kBadInput = 2,       ///< Command line or scene file; or the output cannot be written.
  kInterrupted = 130,  ///< Of headless_sim: ended before all was done; as shells have it after Ctrl-C.
};

}  // namespace dgd_demos
