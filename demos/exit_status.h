// The exit statuses of the programs, as their --help lists them.
#pragma once

namespace dgd_demos {

enum ExitStatus {
  kSuccess = 0,
  kLostBody = 1,       ///< A body left the world, or a value was not finite.
  kNoPath = 1,         ///< plan_motion found none for a seed, or start or goal is in collision.
  kBadInput = 2,       ///< Wrong command line, scene or study; or the output cannot be written.
  kInterrupted = 130,  ///< headless_sim was ended before all was done; the status that shells have after Ctrl-C.
};

}  // namespace dgd_demos
