// How far rounding alone may lead an answer astray. Everything else is a failure, to the soak and to the hard cases.
#pragma once

#include <algorithm>
#include <cmath>

#include "dgd/growth_distance.h"
#include "support/pairs/any_pair.h"

namespace dgd_test {

/// Limits for one pair in its poses. S is the scalar of the query.
template <class S>
struct Limits {
  static constexpr double kEpsilon = dgd::kEpsilon<S>;
  /// Rounding errors of sums of a few terms add up to some units of epsilon.
  static constexpr double kUnits = 16;
  /// An affine map stretches its core's rounding, by up to ten here: 21 units were met in 2e7 queries.
  static constexpr double kSeparationUnits = 64;
  /// Of float, half of all answers need a fifth of a unit, the worst of 2e4 curved ones 20, of 6e7 120.
  static constexpr double kFloatInfeasibilityUnits = 256;
  /// What the points of both sets are off by moves a float's gap and growth distance: 20 units were met in 6e7 queries.
  static constexpr double kPointUnits = 64;

  double size;          ///< Of the pair: its sets' extent and the distance of the centres, metres.
  double carried;       ///< What the growth distance makes of the last digit of a witness point in the world, metres.
  double gap;           ///< Of the certificate of an optimal result.
  double primal;        ///< Metres.
  double dual;          ///< 1 more where the centres are too near for their rounding to tell a normal's sign.
  double separation;    ///< Metres.
  double answer;        ///< Of a growth distance to the true one, relative.
  double answer_floor;  ///< And this, absolute: where the ray's direction is rounding.

  template <int L>
  Limits(const AnyPair<S, L>& pair, const dgd::Result<S, L>& result, bool is_curved, double tolerance) {
    using Point = typename AnyPair<S, L>::Point;
    const Point center_1 = pair.Center(Which::kFirst), center_2 = pair.Center(Which::kSecond);
    const double extent = pair.Extent(), offset = pair.Offset();
    const double distance = (center_2 - center_1).norm();
    const double along = result.normal.template cast<double>().dot(center_2 - center_1);
    // Largest coordinate that a computation meets, in the world or in a core's frame.
    const double reach =
        std::max({center_1.template lpNorm<Eigen::Infinity>(), center_2.template lpNorm<Eigen::Infinity>(), offset}) +
        extent;
    const double growth_distance = double(result.upper_bound);
    // Not less the separation: far apart, that leaves rounding.
    const double support = std::abs(along) / growth_distance;
    size = extent + distance;
    // The certificate's lower bound is along / support: each carries the rounding of its own terms.
    const double gap_units = sizeof(S) == 8 ? kUnits : kPointUnits;
    gap = 1.001 * tolerance + gap_units * kEpsilon * (1 + reach / std::abs(along) + (extent + offset) / support);
    // Both points, in each coordinate; and the certificate's own way back to the centres and into the sets.
    carried = 4 * kEpsilon * (1 + growth_distance) * reach;
    if constexpr (sizeof(S) == 8) {
      primal = (is_curved ? 1e-10 : 1e-12) * size + carried;
    } else {
      primal = kFloatInfeasibilityUnits * kEpsilon * (1 + growth_distance) * reach;
    }
    dual = kUnits * kEpsilon + (std::abs(along) <= kUnits * kEpsilon * reach ? 1 : 0);
    separation = kSeparationUnits * kEpsilon * (reach + distance);
    // A set moved by e is within the one scaled by 1 + e / inradius, and so is the growth distance.
    const double inradii = pair.Inradii();
    answer = gap + kPointUnits * kEpsilon * (extent + offset) / inradii;
    answer_floor = kPointUnits * kEpsilon * reach / inradii;
  }
};

}  // namespace dgd_test
