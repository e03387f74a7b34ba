// Whether sets overlap by so much that hardly anything has to be known of them.
//
// The ball about the Minkowski difference's centre belongs to it (eq. inradius of the paper), and so does the hull of
// that ball and any point of the difference. Of a point far out along the ray, or nearly so, that is most of what the
// ray passes.
#pragma once

#include <algorithm>
#include <optional>

#include "dgd/types.h"

namespace dgd::solver_internal {

/// A point of the hull of a ball about the origin and of another point, as their convex combination.
template <class S, int L>
struct BallHullPoint {
  S share;              ///< Share of the other point.
  Vector<S, L> inside;  ///< The rest: the ball's point times its share.
};

/// @param end       The point that is looked for, metres.
/// @param farther   The hull's other point, metres.
/// @param inradius  Of the ball, metres, > 0.
/// @return nothing if `end` is outside, or so near to the hull's surface that roundoff might put it there.
template <class S, int L>
std::optional<BallHullPoint<S, L>> FindInBallHull(const Vector<S, L>& end, const Vector<S, L>& farther, S inradius) {
  constexpr S kClearly = S(1.001);
  // With a share of the other point, the ball shrinks to the rest: the share for which the end is deepest in it.
  const S ball_sq = inradius * inradius, beyond_sq = farther.squaredNorm() - ball_sq;
  const S end_sq = end.squaredNorm(), along = end.dot(farther);
  if (end_sq > ball_sq && end_sq > along) return std::nullopt;  // Beyond both: most that is outside.
  const S deepest = beyond_sq > 0 ? (kClearly * along - ball_sq) / beyond_sq : S(0);
  const S share = std::clamp(deepest, S(0), S(1));
  const S rest = (1 - share) * inradius;
  if (!((kClearly * end - share * farther).squaredNorm() <= rest * rest)) return std::nullopt;  // Also for NaN.
  const S share_of_end = share / kClearly;
  return BallHullPoint<S, L>{share_of_end, end - share_of_end * farther};
}

}  // namespace dgd::solver_internal
