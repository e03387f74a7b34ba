// A pair of sets whose types the solver knows, as an app's are, and all the ways to ask about it that are compared.
#pragma once

#include <cstdint>
#include <memory>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

enum class SpeedMethod : std::uint8_t {
  kOurs,
  kOursFloat,  ///< The same in float, poses and sets rounded to it.
  // The yardsticks, in bench/textbook/ each.
  kPlain,              ///< The paper's algorithm as printed.
  kInternalExpanding,  ///< IE: cold alone.
  kIncremental,        ///< Inc: of solid polytopes without margins, to rounding error.
  kContactFeatures,    ///< DCF: of sets whose support functions are smooth; cold alone.
  kConic,              ///< DCol: of primitives and hulls; cold alone.
};

/// What is asked, and of whom.
struct SpeedQuestion {
  enum class Start : std::uint8_t { kCold, kWarm };

  SpeedMethod method = SpeedMethod::kOurs;
  Start start = Start::kCold;
  bool is_check = false;     ///< Only yes or no; always cold.
  double tolerance = 0;      ///< Of the relative gap; 0 for the method's own.
  bool second_order = true;  ///< As the two settings of ours with these names.
  bool rounding = true;
};

/// What an answer is worth.
struct SpeedAnswer {
  int iterations = 0;
  double relative_gap = 0;          ///< By dgd/certificate.h, as the next two; 0 for a check.
  double primal_infeasibility = 0;  ///< Metres.
  double dual_infeasibility = 0;
  bool is_failure = false;                  ///< Not optimal; of a check: undecided, or the wrong answer.
  double lower_bound = 0, upper_bound = 0;  ///< On the growth distance; 0 for a check.
};

/// Both sets; made from numbers, then asked in many poses.
template <int L>
class SpeedPair {
 public:
  SpeedPair() = default;
  virtual ~SpeedPair() = default;
  SpeedPair(const SpeedPair&) = delete;
  SpeedPair& operator=(const SpeedPair&) = delete;

  virtual double Extent() const = 0;  ///< Of both sets together, metres.
  /// @param last_pose_2  Of set 2 at the query before: where warm starts come from.
  virtual void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& last_pose_2,
                      const dgd_test::PoseNumbers& pose_2) = 0;
  /// Whether the method has an answer for such sets, and to such a question.
  virtual bool Takes(const SpeedQuestion& question) const = 0;
  virtual double Time(const SpeedQuestion& question, int repeats) const = 0;  ///< Mean of so many in a row, us.
  virtual SpeedAnswer Judge(const SpeedQuestion& question) const = 0;
};

/// Of the types that the classes of bench/pair_class.h draw, and of those that a record holds but for triangles; throws
/// std::invalid_argument for others. The solver is instantiated for each unordered pair of types.
template <int L>
std::unique_ptr<SpeedPair<L>> MakeSpeedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
