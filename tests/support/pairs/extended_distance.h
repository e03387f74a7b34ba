// Growth distance and signed distance in extended precision (long double), for difference quotients of them.
//
// From the plain numbers of the sets, by formulas of their own: shares no code with dgd_core but for the hull whose
// vertices a Dsf is made of, and takes from it only the centres, which are part of what a growth distance means.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "support/pairs/set_numbers.h"

namespace dgd_test {

using Real = long double;
static_assert(std::numeric_limits<Real>::digits >= 64, "difference quotients need more digits than double has");
using RealVector = Eigen::Matrix<Real, 3, 1>;
using RealMatrix = Eigen::Matrix<Real, 3, 3>;

/// Linear velocity of the frame's origin and angular velocity about it, world axes.
struct RealTwist {
  RealVector linear = RealVector::Zero(), angular = RealVector::Zero();
};

/// A set in its pose; sets of the plane are in z = 0.
class ExtendedSet {
 public:
  /// @param center  Of the core, in its own frame, metres.
  ExtendedSet(const SetNumbers& numbers, const Eigen::Vector3d& center, const PoseNumbers& pose);

  /// After a time, at a constant twist.
  ExtendedSet Moved(const RealTwist& twist, Real time) const;

  RealVector Center() const { return rotation_ * center_ + translation_; }
  /// A farthest point of the set along a direction of any length but 0, from the centre, world axes; metres.
  RealVector SupportFromCenter(const RealVector& direction) const;

 private:
  RealVector CoreSupport(const RealVector& direction) const;

  SetNumbers numbers_;
  std::vector<RealVector> points_;
  RealVector center_, translation_;
  RealMatrix rotation_;
};

/// The growth distance; to about 20 units of long double's last digit.
/// @param dimension  2 or 3.
/// @param normal     About the optimal one; only the time depends on how near.
Real ExtendedGrowthDistance(const ExtendedSet& set_1, const ExtendedSet& set_2, int dimension,
                            const Eigen::Vector3d& normal);

/// The signed distance in space, as the best near a normal; of sets that are apart, of all.
Real ExtendedSignedDistance(const ExtendedSet& set_1, const ExtendedSet& set_2, const Eigen::Vector3d& normal);

/// The derivative of distance(time) at 0 by central differences, and how far two steps agree.
struct DifferenceQuotient {
  Real rate;
  Real uncertainty;  ///< Difference of the quotients by the two steps: large where there is a kink nearby.
};

/// Richardson's extrapolation of the steps `step` and 2 * `step`: its error is of the fourth order.
template <class Distance>
DifferenceQuotient DifferenceQuotientOf(const Distance& distance, Real step) {
  const Real narrow = (distance(step) - distance(-step)) / (2 * step);
  const Real wide = (distance(2 * step) - distance(-2 * step)) / (4 * step);
  return {narrow + (narrow - wide) / 3, std::abs(narrow - wide)};
}

}  // namespace dgd_test
