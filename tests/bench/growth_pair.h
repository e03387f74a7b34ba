// A pair of sets, and the ways to its growth distance that are compared: each is timed, and its answer judged.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "bench/method_figures.h"
#include "bench/pair_class.h"

namespace dgd_bench {

enum class GrowthAlgorithm : std::uint8_t {
  kOurs,
  kPlain,  ///< The paper's algorithm as printed (textbook/plain_algorithm.h).
  // What the paper compares with, in textbook/ each; MakeComparedPair() has them.
  kInternalExpanding,  ///< IE: cold alone.
  kIncremental,        ///< Inc: of solid polytopes without margins, to roundoff.
  kContactFeatures,    ///< DCF: of sets whose support functions are smooth; cold alone.
  kConic,              ///< DCol: of primitives and hulls; cold alone.
};

/// One way to query a pair.
struct GrowthQuery {
  GrowthAlgorithm algorithm = GrowthAlgorithm::kOurs;
  bool is_warm = false;    ///< From the result at the pair's last pose.
  bool is_check = false;   ///< Collision yes or no; always cold.
  double tolerance = 0;    ///< Relative gap; 0 for the algorithm's own.
  int max_iterations = 0;  ///< Of ours and of the paper's algorithm; 0 for the algorithm's own.
};

struct GrowthAnswer {
  MethodSample sample;                      ///< Errors by dgd/certificate.h; none for a check. Without a time.
  double lower_bound = 0, upper_bound = 0;  ///< On the growth distance; 0 for a check.
};

/// Two sets, made once, then queried in many poses.
class GrowthPair {
 public:
  GrowthPair() = default;
  virtual ~GrowthPair() = default;
  GrowthPair(const GrowthPair&) = delete;
  GrowthPair& operator=(const GrowthPair&) = delete;

  virtual double Extent() const = 0;  ///< Of both sets together, metres.
  virtual void MoveTo(const PairPoses& poses) = 0;
  /// Whether the algorithm takes such sets, and such a query.
  virtual bool Takes(const GrowthQuery& query) const = 0;
  virtual double Time(const GrowthQuery& query, int repeats) const = 0;  ///< Mean of so many in a row, us.
  virtual GrowthAnswer Solve(const GrowthQuery& query) const = 0;
  /// By a linear program in extended precision or a closed form, where there is such.
  virtual std::optional<double> ExactGrowthDistance() const = 0;
};

using MakePair = std::unique_ptr<GrowthPair> (*)(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

/// Ours and the paper's algorithm, of two sets of the same dimension. Ours is dgd::AnySet's, as users get it; in the
/// plane, and for two differentiable support functions, the template.
std::unique_ptr<GrowthPair> MakeGrowthPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
