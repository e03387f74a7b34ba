// Processes on this machine, one for each run: a run that crashes takes nothing else with it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "sweep/workers.h"

namespace dgd_demos {

class LocalWorkers : public Workers {
 public:
  /// @param jobs  runs at a time, at least 1.
  explicit LocalWorkers(int jobs);
  /// Ends what still runs.
  ~LocalWorkers() override;

  int idle() const override { return jobs_ - busy(); }
  int busy() const override { return static_cast<int>(children_.size()); }
  /// @throws std::runtime_error if no process can be made.
  void Start(const RunSpec& run) override;
  std::optional<RunRecord> Wait(std::chrono::milliseconds patience) override;

 private:
  struct Child {
    int run;  // RunSpec::number
    pid_t process;
    int pipe;            // Of its output and error stream.
    std::string output;  // So far.
  };

  int jobs_;
  std::vector<Child> children_;
};

/// Runs a program in the place of this one, as far as its streams go, until it ends.
/// @return its exit status; 128 and its number if a signal ended it, as shells have it.
/// @throws std::runtime_error if it cannot be started.
int RunAndWait(const std::string& program, const std::vector<std::string>& arguments);

/// This program, or its sibling in the same folder that is built for the other precision.
/// @param precision  "float" or "double".
/// @throws std::runtime_error if it is not there.
std::string ProgramFor(const std::string& precision);

}  // namespace dgd_demos
