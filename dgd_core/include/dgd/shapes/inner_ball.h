// Balls inside a convex set that is given by the planes of its faces: what a wide, flat or long body is scaled about
// when it meets a small one (CenteredCore).
#pragma once

#include <span>

#include "dgd/assert.h"
#include "dgd/types.h"

namespace dgd {

template <class S, int L = 3>
struct InnerBall {
  Vector<S, L> center;
  S radius;  ///< Metres; the ball lies in the set.
};

/// The plane { x : <normal, x> = offset }, with the set below it.
template <class S, int L = 3>
struct FacePlane {
  Vector<S, L> normal;  ///< Outward, of unit length.
  S offset;             ///< Metres.

  /// Metres below the plane; negative above it.
  S Depth(const Vector<S, L>& point) const { return offset - normal.dot(point); }
};

/// The face that a point is least below, or most above.
template <class S, int L>
const FacePlane<S, L>& NearestFace(std::span<const FacePlane<S, L>> faces, const Vector<S, L>& point) {
  DGD_ASSERT(!faces.empty());
  const FacePlane<S, L>* nearest = &faces[0];
  S least = nearest->Depth(point);
  for (const FacePlane<S, L>& face : faces.subspan(1)) {
    const S depth = face.Depth(point);
    if (!(depth < least)) continue;
    least = depth;
    nearest = &face;
  }
  return *nearest;
}

/// A ball inside the set whose centre is behind the face that `point` is in front of, as deep as the given ball, and as
/// near to the point otherwise as that ball's radius allows, or an eighth of it where there is less room.
///
/// The point is moved behind the face that it is least behind of, and again. At right angles that ends at the nearest
/// centre, as a box has it; at acute ones it is cut off, and the rest is the way from the given ball.
/// @param ball  In the set; of positive radius.
/// @return the given ball if roundoff, or a point that is not finite, leaves no other.
template <class S, int L>
InnerBall<S, L> BallNear(std::span<const FacePlane<S, L>> faces, const InnerBall<S, L>& ball,
                         const Vector<S, L>& point) {
  DGD_ASSERT(ball.radius > 0);
  constexpr int kFullSteps = 2, kMostSteps = 3;
  const S least = ball.radius / 8, enough = least * S(0.75);
  InnerBall<S, L> moved{point, 0};
  for (int step = 0;; ++step) {
    const bool is_full = step < kFullSteps;
    const FacePlane<S, L>& face = NearestFace(faces, moved.center);
    moved.radius = face.Depth(moved.center);
    if (moved.radius >= (is_full ? ball.radius * S(0.99) : enough)) return moved;
    if (step == kMostSteps) break;
    moved.center -= ((is_full ? ball.radius : least) - moved.radius) * face.normal;
  }
  // The depth below the nearest face, on the way from the ball's centre, is at least what is between those of its ends.
  const S part = (ball.radius - least) / (ball.radius - moved.radius);
  moved.center = ball.center + part * (moved.center - ball.center);
  moved.radius = NearestFace(faces, moved.center).Depth(moved.center);
  return moved.radius >= enough ? moved : ball;  // False for NaN.
}

}  // namespace dgd
