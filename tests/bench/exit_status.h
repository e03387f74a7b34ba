// The exit statuses of the benchmarks, as their --help lists them.
#pragma once

namespace dgd_bench {

enum ExitStatus {
  kSuccess = 0,
  kFailedQuery = 1,  ///< A growth distance in double was not optimal, or a yes/no was wrong.
  kBadInput = 2,     ///< Command line or mesh; or the output cannot be written.
};

}  // namespace dgd_bench
