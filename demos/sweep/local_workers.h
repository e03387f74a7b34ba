// Processes on this machine, one for each run: a run that crashes takes no other with it.
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
  /// Ends the runs that have not ended.
  ~LocalWorkers() override;

  int idle() const override { return jobs_ - static_cast<int>(children_.size()); }
  /// @throws std::runtime_error if no process can be started.
  void Start(const RunSpec& run) override;
  std::optional<RunRecord> Wait(std::chrono::milliseconds patience) override;

 private:
  struct Child {
    int run;  // RunSpec::number
    pid_t process;
    int pipe;            // Reads its output and error stream.
    std::string output;  // What has been read so far.
  };

  int jobs_;
  std::vector<Child> children_;
};

}  // namespace dgd_demos
