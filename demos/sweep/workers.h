// Processes that carry out the runs of a study, on this machine or on others.
#pragma once

#include <chrono>
#include <optional>

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

class Workers {
 public:
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  virtual ~Workers() = default;

  virtual int idle() const = 0;  ///< Number of workers without a run.
  /// @pre idle() > 0.
  virtual void Start(const RunSpec& run) = 0;
  /// Record of a run that has ended, by a crash as well; nothing if none ends within the time.
  /// @pre a run has been started and not been returned yet.
  virtual std::optional<RunRecord> Wait(std::chrono::milliseconds patience) = 0;
};

}  // namespace dgd_demos
