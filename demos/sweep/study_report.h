// What a study shows: one CSV with a row a run, and tables of medians.
#pragma once

#include <map>
#include <string>

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

/// A row for each run that is done, in the study's order, so that it is the same whoever carried out the runs, and in
/// whatever order: only narrowphase_us_per_query and wall_time_s are times. An empty cell is a figure that a run does
/// not have, or a time that never came.
std::string StudyCsv(const Study& study, const std::map<int, RunRecord>& records);

/// A table for each world, change and precision: columns for the narrowphases, medians over the seeds with their
/// interquartile range. What was lost or failed is listed under its table.
std::string StudyTables(const Study& study, const std::map<int, RunRecord>& records);

}  // namespace dgd_demos
