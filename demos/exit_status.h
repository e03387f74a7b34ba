// The exit statuses of the programs that simulate scenes, as their --help lists them.
#pragma once

namespace dgd_demos {

enum ExitStatus {
  kSuccess = 0,
  kLostBody = 1,  ///< A body left the world, or a value was not finite.
  kBadInput = 2,  ///< Command line or scene file; or the output cannot be written.
};

}  // namespace dgd_demos
