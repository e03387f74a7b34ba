// The table for people.
#pragma once

#include <string>
#include <vector>

#include "bench/measurement.h"

namespace dgd_bench {

/// The blocks of one margin: a heading, and per class a row for each method.
std::string FormatTable(const std::vector<Block>& blocks);

/// One line: the ratio of the second method's p50 (growth distance, double, cold) to the first one's (Bullet), class by
/// class, and in how many it is below 1.
std::string FormatVerdict(const std::vector<Block>& blocks);

/// What the columns mean.
std::string TableFooter();

}  // namespace dgd_bench
