// An ellipsoid, its axes along its frame's and centred; in the plane, an ellipse.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "dgd/inlining.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class S, int L = 3>
class Ellipsoid {
 public:
  using Scalar = S;

  /// @param semi_axes  Metres, each >= 0; a zero makes a disc, a segment or a point.
  explicit Ellipsoid(const Vector<S, L>& semi_axes) : semi_axes_(semi_axes) {
    for (int axis = 0; axis < L; ++axis) RequireLength(semi_axes[axis], true, "ellipsoid semi-axis");
  }

  /// A^2 d / |A d|, with the semi-axes on A's diagonal. The centre where A d is 0: all points are as high then.
  SupportPoint<S, L> Support(const Vector<S, L>& direction) const {
    return {semi_axes_.cwiseProduct(OnBall(direction).point), 0};
  }
  /// The one piece is all of it. No derivative, NaN, where A d is 0.
  CurvedPoint<S, L> PieceSupport(FeatureId, const Vector<S, L>& direction) const {
    DGD_ASSERT(semi_axes_.minCoeff() >= 0);
    const BallPoint ball = OnBall(direction);
    CurvedPoint<S, L> curved;
    curved.point = semi_axes_.cwiseProduct(ball.point);
    if (!(ball.length > 0)) {
      curved.derivative.setConstant(semi_axes_.isZero(0) ? S(0) : std::numeric_limits<S>::quiet_NaN());
      return curved;
    }
    // A (I - n n^T) A / |A d|; on the diagonal, 1 - n_i^2 is the others' sum, which does not cancel.
    const Vector<S, L> scaled = semi_axes_ / ball.length;
    for (int row = 0; row < L; ++row) {
      for (int column = 0; column < L; ++column) {
        S part = -ball.point[row] * ball.point[column];
        if (row == column) {
          part = 0;
          for (int other = 0; other < L; ++other) part += other == row ? S(0) : ball.point[other] * ball.point[other];
        }
        curved.derivative(row, column) = part * semi_axes_[row] * scaled[column];
      }
    }
    return curved;
  }
  FeatureId PieceCount() const { return 1; }

  Vector<S, L> Center() const { return Vector<S, L>::Zero(); }
  S Inradius() const { return semi_axes_.minCoeff(); }
  /// See SpreadCore.
  auto Spread() const { return SpreadOfExtents<S, L>(semi_axes_); }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector<S, L>& direction) const { return OnBall(direction).length; }

  /// Distance of `point` to the core, metres; 0 inside. Right to some units of roundoff of the distance or the largest
  /// axis.
  S Distance(const Vector<S, L>& point) const;

  /// The support point: no face is flat.
  void SupportFace(const Vector<S, L>& direction, SupportingFace<S>& face) const requires(L == 3) {
    face.Add(Support(direction).point);
  }

 private:
  /// A d / |A d|, a point of the unit ball, and |A d|. Both 0 where A d is.
  struct BallPoint {
    Vector<S, L> point;
    S length;
  };
  BallPoint OnBall(const Vector<S, L>& direction) const {
    const Vector<S, L> point = semi_axes_.cwiseProduct(direction);
    const S length = point.norm();
    if (!(length > kLeastSize<S> && length < kGreatestSize<S>)) return OnBallOfAnySize(direction);
    return {point / length, length};
  }

  /// Scaled twice: neither the product nor its square under- or overflows. By powers of two: no digit depends on it.
  DGD_COLD BallPoint OnBallOfAnySize(const Vector<S, L>& direction) const {
    const auto power_near = [](S size) { return std::ldexp(S(1), std::ilogb(size)); };
    const S longest = direction.cwiseAbs().maxCoeff();
    if (!(longest > 0)) return {Vector<S, L>::Zero(), 0};
    const S direction_scale = power_near(longest);
    Vector<S, L> point = semi_axes_.cwiseProduct(direction / direction_scale);
    const S largest = point.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return {Vector<S, L>::Zero(), 0};
    const S scale = power_near(largest);
    point /= scale;
    const S length = point.norm();
    return {point / length, length * scale * direction_scale};
  }

  Vector<S, L> semi_axes_;
};

template <class S, int L>
S Ellipsoid<S, L>::Distance(const Vector<S, L>& point) const {
  // The unit is the larger of the ellipsoid and the point, whose squares could under- or overflow. By symmetry, the
  // point is in the first orthant.
  const double unit = static_cast<double>(std::max(semi_axes_.maxCoeff(), point.cwiseAbs().maxCoeff()));
  if (!(unit > 0)) return 0;
  const Vector<double, L> axes = semi_axes_.template cast<double>() / unit;
  const Vector<double, L> x = point.template cast<double>().cwiseAbs() / unit;
  // The nearest point is a_i^2 x_i / (t + a_i^2) for the t > 0 that puts it on the border, the zero of a function that
  // falls and is convex there (Eberly 2013, "Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid");
  // t = 0 inside, and on the face of a flat one.
  double slope = 0;
  const auto excess = [&](double t) {
    double sum = -1;
    slope = 0;
    for (int i = 0; i < L; ++i) {
      if (!(axes[i] > 0 && x[i] > 0)) continue;
      const double reach = axes[i] * x[i] / (t + axes[i] * axes[i]);
      sum += reach * reach;
      slope -= 2 * reach * reach / (t + axes[i] * axes[i]);
    }
    return sum;
  };
  double low = 0;
  if (excess(0) > 0) {
    // At `low`, one term of the sum alone is 1 or more; at `high`, all terms with the smallest denominator are 1.
    double moment_sq = 0;
    for (int i = 0; i < L; ++i) {
      low = std::max(low, axes[i] * x[i] - axes[i] * axes[i]);
      moment_sq += axes[i] * x[i] * axes[i] * x[i];
    }
    double high = std::sqrt(moment_sq);
    // Newton's steps from the left never pass the zero but for roundoff; bisection where they creep. Ends when no
    // number is left between the bounds.
    for (int i = 0; i < 200 && low < high; ++i) {
      const double value = excess(low);
      if (!(value > 0)) break;
      const double stepped = low - value / slope;
      if (!(stepped > low)) break;
      low = std::min(stepped, high);
      const double middle = low + (high - low) / 2;
      if (excess(middle) > 0) {
        low = middle;
      } else {
        high = middle;
      }
    }
  }
  Vector<double, L> way;
  for (int i = 0; i < L; ++i) {
    const double denominator = low + axes[i] * axes[i];
    way[i] = denominator > 0 ? low / denominator * x[i] : x[i];  // For tiny axes, x / denominator may not be finite.
  }
  return static_cast<S>(unit * way.norm());
}

/// An ellipse of the plane.
template <class S>
using Ellipse = Ellipsoid<S, 2>;

}  // namespace dgd
