// What is counted of the cases of one pair of types: whole numbers and largest figures, so that the order in which
// cases are counted changes nothing.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>

namespace dgd_test {

/// The largest figure so far and the case it is of, the first of equals. NaN counts as infinite.
struct Worst {
  double figure = 0;
  std::int64_t index = -1;

  void Take(double new_figure, std::int64_t new_index);
};

struct Tally {
  /// Counted one by one up to this; the settings allow 100.
  static constexpr std::size_t kMostIterations = 200;

  std::int64_t pairs = 0;
  std::int64_t queries = 0;                                    ///< Growth distances: first and following frames.
  std::array<std::int64_t, kMostIterations + 1> iterations{};  ///< How many queries took that many.
  Worst relative_gap;                                          ///< Of optimal results, by the certificate.
  Worst primal_infeasibility;  ///< Beyond the last digit of the points, relative to the pair's size.
  Worst dual_infeasibility;
  Worst separation_error;          ///< Relative to the pair's size.
  Worst growth_distance_error;     ///< Relative to the known growth distance, or float to double.
  std::int64_t non_optimal = 0;    ///< Queries.
  std::int64_t non_monotone = 0;   ///< Queries with a bound that got worse on the way.
  std::int64_t disagreements = 0;  ///< Collision checks against the growth distance.
  std::int64_t failed_pairs = 0;   ///< With any complaint.

  void CountIterations(int count);
  void Merge(const Tally& other);

  double MeanIterations() const;
  /// The least count that `share` of all queries do not exceed.
  int IterationPercentile(double share) const;
};

/// Exactly, in text, on one line.
void Write(std::ostream& out, const Tally& tally);
/// Sets the stream's fail bit if there is no such line.
void Read(std::istream& in, Tally& tally);

}  // namespace dgd_test
