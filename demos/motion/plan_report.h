// What plan_motion prints and leaves on disk of its runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/check_comparison.h"
#include "motion/plan_run.h"
#include "report/csv_file.h"

namespace dgd_demos {

/// A row a figure with its unit; of several runs the median, the least and the greatest. Runs without a plan count only
/// in the row that says how many there are.
std::string FormatRuns(const std::vector<PlanRun>& runs);

/// Where along the paths the least distances are, and between what: of one run.
std::string FormatPlaces(const CollisionModel& model, const PlanRun& run);

/// A line for each pair that touched while the path was carried out; empty if none did.
std::string FormatContacts(const ExecutionResult& execution);

/// Times and differing answers of the checks, a row a library.
std::string FormatComparison(const std::vector<CheckTimes>& times);

/// The figures of FormatRuns() and of single runs for programs: one line a run, appended as soon as it is done.
class RunsCsv {
 public:
  explicit RunsCsv(const std::filesystem::path& file);
  void Write(const PlanRun& run);

 private:
  CsvFile csv_;
};

/// A row a configuration: place along the path, joint angles, flange, and the least signed distance there.
/// @throws std::runtime_error if the file cannot be written.
void WritePathCsv(const std::filesystem::path& file, const CollisionModel& model, const JointPath& path);

}  // namespace dgd_demos
