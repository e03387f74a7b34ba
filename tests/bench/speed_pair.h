// A pair of sets whose types the solver knows, as an app's are, and all the ways to ask about it that are compared.
#pragma once

#include <cstdint>
#include <memory>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// Ours, and the paper's algorithm as printed (bench/textbook/), in turns.
enum class SpeedMethod : std::uint8_t { kCold, kPlainCold, kWarm, kPlainWarm, kCheck, kPlainCheck };
inline constexpr int kSpeedMethodCount = 6;

/// What an answer is worth.
struct SpeedAnswer {
  int iterations = 0;
  double relative_gap = 0;          ///< By dgd/certificate.h, as the next; 0 for a check.
  double primal_infeasibility = 0;  ///< As a part of the pair's size.
  bool is_failure = false;          ///< Not optimal; of a check: undecided, or the wrong answer.
};

/// Both sets, in double; made from numbers, then asked in many poses.
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
  virtual double Time(SpeedMethod method, int repeats) const = 0;  ///< Mean of so many queries in a row, us.
  virtual SpeedAnswer Judge(SpeedMethod method) const = 0;
};

/// Of the types that the classes of bench/pair_class.h draw; throws std::invalid_argument for others. The solver is
/// instantiated for each unordered pair of types: the sets may change places.
template <int L>
std::unique_ptr<SpeedPair<L>> MakeSpeedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
