// What all the solvers have in common here: they can be timed on one pair, and their answer can be judged.
#pragma once

#include <limits>
#include <memory>

#include "bench/hull_pair.h"

namespace dgd_bench {

/// Not computed by this solver: NaN, which the table leaves blank.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What an answer is worth, by the oracle and by the certificate.
struct Judgement {
  bool is_missing = false;              ///< The solver reported nothing.
  bool is_failure = false;              ///< The solver says that it did not converge; of a yes/no: the wrong one.
  double normal_error = kNone;          ///< m; see NormalError().
  double iterations = kNone;            ///< Evaluations of the support functions.
  double relative_gap = kNone;          ///< Growth distance over the one that the normal proves, less 1.
  double primal_infeasibility = kNone;  ///< m; see dgd::Certificate.
};

/// One solver, made ready for one pair: shapes built, poses converted.
class Query {
 public:
  Query() = default;
  virtual ~Query() = default;
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  virtual double Time(int repeats) const = 0;  ///< Mean time of the query, us.
  virtual Judgement Judge(const HullPair& pair) const = 0;
};

/// A row of the table.
struct Method {
  const char* key;    ///< In the CSV file.
  const char* title;  ///< In the table.
  std::unique_ptr<Query> (*make_query)(const HullPair& pair);
  bool must_not_fail;  ///< A failure makes the program fail.
};

}  // namespace dgd_bench
