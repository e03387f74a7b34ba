// The CSV of a comparison: one row a run, on disk as soon as the run is done.
#pragma once

#include <filesystem>

#include "report/csv_file.h"
#include "report/step_csv.h"
#include "simulation/run_summary.h"

namespace dgd_demos {

class RunCsv {
 public:
  /// Creates or overwrites the file and writes its head.
  /// @throws std::runtime_error if the file cannot be written.
  explicit RunCsv(const std::filesystem::path& file);

  /// Appends a row: what the run was, then all Figures() of it, an empty cell for what it does not have or never came.
  /// @throws std::runtime_error if that fails, as on a full disk.
  void Write(const RunInfo& info, const RunSummary& summary);

 private:
  CsvFile csv_;
};

}  // namespace dgd_demos
