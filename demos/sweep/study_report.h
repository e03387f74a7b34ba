// The results of a study: one CSV with a row a run, and tables of medians.
#pragma once

#include <map>
#include <string>

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

/// A row for each run that is done, in the study's order. The text does not depend on the processes that carried out
/// the runs and their order, except for the times narrowphase_us_per_query and wall_time_s. An empty cell is a figure
/// that a run does not have, or a time that never came.
std::string StudyCsv(const Study& study, const std::map<int, RunRecord>& records);

/// A table for each world, change and precision: columns for the narrowphases, medians over the seeds with their
/// interquartile range. Runs that were lost or failed are listed under their table.
std::string StudyTables(const Study& study, const std::map<int, RunRecord>& records);

}  // namespace dgd_demos
