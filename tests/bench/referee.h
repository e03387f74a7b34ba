// Judges signed distances by support functions alone: belongs to none of the solvers.
#pragma once

#include <Eigen/Core>

#include "bench/peers/peer.h"
#include "support/distance_bounds.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {

/// What an answer is off by, metres, never below 0 but for rounding.
struct SeparationErrors {
  double normal = 0;   ///< The signed distance less the separation along the answer's normal: how much longer a way it
                       ///< takes to part the sets along it, or how much of their distance goes unseen.
  double depth = 0;    ///< How far the reported separation is from the one along its own normal.
  double witness = 0;  ///< Of the two points, the one farther outside of its set.
  bool is_wrong = false;  ///< Yes or no: apart where they overlap, or the other way round.
};

/// On the signed distance of the sets; the normal is from the second to the first. Some 50 us.
dgd_test::DistanceBounds BoundSignedDistance(const dgd_test::AnyPair<double, 3>& pair);

/// The pair in one pose.
class Referee {
 public:
  /// Bounds the signed distance from both sides, as above.
  /// @param pair  Must outlive this, and stay where it is.
  explicit Referee(const dgd_test::AnyPair<double, 3>& pair);

  /// By more than a millionth of the pair's extent: nearer to touching, yes or no is no question in float.
  bool AreApart() const { return lower_ > negligible_; }
  bool Overlap() const { return upper_ < -negligible_; }

  SeparationErrors Judge(const SeparationAnswer& answer) const;

 private:
  double OutsideOf(dgd_test::Which which, const Eigen::Vector3d& point) const;

  const dgd_test::AnyPair<double, 3>& pair_;
  double negligible_;     // Metres.
  double lower_, upper_;  // On the signed distance, metres.
};

}  // namespace dgd_bench
