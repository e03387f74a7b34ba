// What the benchmark `iterations` measures of one class: iterations, certificates and times, in each of some ways of
// asking.
#pragma once

#include <vector>

#include "bench/class_options.h"
#include "dgd/growth_distance.h"
#include "support/pairs/tally.h"

namespace dgd_bench {

/// What a query starts from: nothing, or the answer at a pose 1 % of the extent and 0.01 rad away.
enum class Start {
  kCold,
  kWarm,
  kLastNormal,  ///< Of that answer, the normal alone: the dual warm start of the paper.
};

/// A way of asking: settings, and from where.
struct IterationVariant {
  const char* title;
  dgd::Settings<double> settings;
  Start start;
  bool must_be_optimal;  ///< Else rounding, or the limit of iterations, may be in the way.
};
const std::vector<IterationVariant>& IterationVariants();

/// One line of the table.
struct IterationRow {
  const char* title;
  dgd_test::Tally tally;
  double microseconds_p50;
};

/// One row per variant; a progress bar meanwhile.
std::vector<IterationRow> CountIterations(const PairClass& pair_class, const Meshes& meshes,
                                          const ClassOptions& options);

}  // namespace dgd_bench
