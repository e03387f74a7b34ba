// Who carries out the runs of a study: processes on this machine, or on others.
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

  virtual int idle() const = 0;
  virtual int busy() const = 0;
  /// @pre idle() > 0.
  virtual void Start(const RunSpec& run) = 0;
  /// The record of a run that has ended, of a run that crashed as well; nothing if none ends within the time.
  /// @pre busy() > 0.
  virtual std::optional<RunRecord> Wait(std::chrono::milliseconds patience) = 0;
};

}  // namespace dgd_demos
