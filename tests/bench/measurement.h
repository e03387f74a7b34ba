// All that is measured on the pairs of one class and margin, and what remains of it for the table.
#pragma once

#include <array>
#include <vector>

#include "bench/hull_pair.h"
#include "bench/methods.h"

namespace dgd_bench {

/// One method on one pair.
struct Sample {
  double microseconds;
  Judgement judgement;
};

/// One pair, by all methods in the order of kMethods.
struct PairRow {
  double signed_distance;  ///< m
  std::array<Sample, kMethods.size()> samples;
};

/// The pairs of one class at one margin.
struct Block {
  const DistanceClass* distance_class;
  double margin;  ///< m
  std::vector<PairRow> rows;
};

struct TimingEffort {
  int repeats;  ///< Of one query in a row, of which the mean is taken.
  int rounds;   ///< Of all methods in turn, of which a method's least mean is its time for the pair.
};

/// Times and judges all methods on the pair. They take turns, so that a machine that slows down slows all of them; the
/// least of the rounds leaves out what the scheduler took.
PairRow Measure(const HullPair& pair, const TimingEffort& effort);

/// Figures of one method over the pairs of a block; NaN where the method has none. Times in us, by nearest rank.
struct Summary {
  double p50, p99, p9999, slowest;
  double mean_iterations;
  double normal_error_p99, normal_error_max;  ///< m
  double relative_gap_max;
  double primal_infeasibility_max;  ///< m
  double missing, failures;         ///< Pairs.
};
Summary Summarize(const Block& block, std::size_t method);

}  // namespace dgd_bench
