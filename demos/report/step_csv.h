// The CSV of a run: one row a step.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "report/csv_file.h"
#include "report/flush_timer.h"
#include "simulation/step_record.h"

namespace dgd_demos {

/// What a run was, for the head of its CSV.
struct RunInfo {
  std::string scene;
  std::uint64_t seed;
  std::string narrowphase;
  std::string precision;
  std::string build_type;
};

/// Numbers read back to the bit: two runs are equal to the bit exactly if their files are, but for the
/// measured narrowphase_us.
class StepCsv {
 public:
  /// A file that is created gets a head.
  /// @throws std::runtime_error if the file cannot be written.
  StepCsv(const std::filesystem::path& file, const RunInfo& info, OpenMode mode = OpenMode::kCreate);

  /// Appends a row, and now and then flushes; see FlushTimer.
  /// @throws std::runtime_error if that fails, as on a full disk.
  void Write(const StepRecord& step);
  /// Hands all rows to the operating system: they survive a crash of this program.
  /// @throws std::runtime_error if that fails.
  void Flush() { csv_.Flush(); }

  void Serialize(StateArchive& archive) { csv_.Serialize(archive); }

 private:
  CsvFile csv_;
  FlushTimer timer_;
};

}  // namespace dgd_demos
