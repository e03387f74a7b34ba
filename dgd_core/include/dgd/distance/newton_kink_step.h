// Newton's steps towards the normal along which a convex set made of smooth pieces is nearest to an origin, where that
// normal may be on a kink between pieces: as an edge of a box on the side of a cylinder.
//
// On the unit sphere, the support function h(n) of a piece has the gradient p - h n, p its support point along n, and
// the Hessian H - h I across n, H = dp/dn. With the origin outside h is negative near the best normal, and the Hessian
// positive definite; with the origin inside it is so where the surface curves less than a sphere of radius h, as it
// must at a local minimum.
//
// The set's support function is the largest of the pieces' own. Of two or three pieces that are level at the minimum,
// each with gradient g_i and Hessian H_i - h I across the normal, a step s keeps them level,
//
//     h_1 + <g_1, s> = h_i + <g_i, s>,
//
// and has the least value of their Lagrangian, of which the weights are those of the pieces' points in the point of
// their simplex that is nearest to the origin, or to its foot on the set's supporting plane if the origin is inside:
// sequential quadratic programming. With the origin outside, the Lagrangian is convex. With the origin inside it need
// not be, and the step goes downhill, by the caller's reach at most.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "dgd/assert.h"
#include "dgd/invert.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// A step from one unit normal to another.
template <class S>
struct NormalStep {
  bool is_valid = false;  ///< If not, there is no step, and the rest is meaningless.
  Vector3<S> next;        ///< The next normal, unit length.
  S gain;                 ///< Fall of the height, by the model; metres.
};

/// One piece's support function about a unit normal. All vectors are in one frame, about the origin that is meant.
template <class S>
struct PieceModel {
  Vector3<S> point;              ///< The piece's support point along the normal, metres.
  SquareMatrix<S, 2> curvature;  ///< How it moves with the normal, along two tangents; metres.
  S weight;                      ///< Weight of the piece; all sum up to 1.
};

/// Up to three pieces.
template <class S>
struct PieceModels {
  std::array<PieceModel<S>, 3> models;
  std::size_t size = 0;

  const PieceModel<S>& operator[](std::size_t i) const { return models[i]; }
  PieceModel<S>& operator[](std::size_t i) { return models[i]; }
};

/// The model of all pieces together about a unit normal, as a function of the step across it.
template <class S>
class KinkModel {
 public:
  using Tangents = Eigen::Matrix<S, 2, 3>;

  /// @param normal    Unit length.
  /// @param tangents  Rows: two unit vectors across `normal` and across each other.
  /// @param pieces    At least one. All are kept as references.
  KinkModel(const Vector3<S>& normal, const Tangents& tangents, const PieceModels<S>& pieces)
      : normal_(normal), tangents_(tangents), pieces_(pieces) {
    DGD_ASSERT(pieces.size >= 1 && pieces.size <= pieces.models.size() && IsUnitOrNan(normal));
    for (std::size_t i = 0; i < pieces.size; ++i) {
      const PieceModel<S>& piece = pieces[i];
      const S height = normal.dot(piece.point);
      height_ += piece.weight * height;
      gradient_ += piece.weight * (tangents * piece.point);
      hessian_ += piece.weight * (piece.curvature - height * SquareMatrix<S, 2>::Identity());
    }
  }

  std::size_t Size() const { return pieces_.size; }
  /// Height, gradient and Hessian of the Lagrangian, the pieces' weighed mean, at the normal; metres. The Hessian is
  /// not finite where a support function has no second derivative: along a rim's axis.
  S Height() const { return height_; }
  const Vector2<S>& Gradient() const { return gradient_; }
  const SquareMatrix<S, 2>& Hessian() const { return hessian_; }
  /// Slope of a piece, less the first one's.
  Vector2<S> Slope(std::size_t i) const { return tangents_ * (pieces_[i].point - pieces_[0].point); }
  /// Height of the first piece over another one.
  S Lead(std::size_t i) const { return normal_.dot(pieces_[0].point - pieces_[i].point); }
  /// Squared distance of points that are alike but for roundoff; metres^2.
  S AlikeSquared() const { return kEpsilon<S> * kEpsilon<S> * pieces_[0].point.squaredNorm(); }

  /// The step to where three pieces are level.
  bool LevelThree(Vector2<S>& step) const {
    DGD_ASSERT(Size() == 3);
    SquareMatrix<S, 2> slopes, inverse;
    slopes << Slope(1).transpose(), Slope(2).transpose();
    if (!(std::abs(slopes.determinant()) > AlikeSquared()) || !Invert(slopes, inverse)) return false;
    step = inverse * Vector2<S>(Lead(1), Lead(2));
    return true;
  }

  /// @param step  Across the normal, in its length. It ends at 45 degrees: the model is one of the surroundings.
  /// @return with what the Lagrangian falls by as its gain; not valid if the step is not finite.
  NormalStep<S> Take(Vector2<S> step) const {
    NormalStep<S> result;
    const S length = step.norm();
    if (!std::isfinite(length)) return result;
    if (length > 1) step /= length;
    result.is_valid = true;
    result.next = (normal_ + tangents_.transpose() * step).normalized();
    result.gain = -gradient_.dot(step) - step.dot(hessian_ * step) / 2;
    return result;
  }

 private:
  const Vector3<S>& normal_;
  const Tangents& tangents_;
  const PieceModels<S>& pieces_;
  S height_ = 0;
  Vector2<S> gradient_ = Vector2<S>::Zero();
  SquareMatrix<S, 2> hessian_ = SquareMatrix<S, 2>::Zero();
};

/// Newton's step with the origin outside of the set.
/// @return not valid if the pieces' points are in line with the normal, or alike, or if a support function has no
///         second derivative there.
template <class S>
NormalStep<S> StepOnKink(const KinkModel<S>& kink) {
  if (!kink.Hessian().allFinite()) return {};
  Vector2<S> step;
  if (kink.Size() == 1) {
    SquareMatrix<S, 2> inverse;
    if (!Invert(kink.Hessian(), inverse)) return {};
    step = -inverse * kink.Gradient();
  } else if (kink.Size() == 2) {
    const Vector2<S> along = kink.Slope(1);
    const S length_sq = along.squaredNorm();
    if (!(length_sq > kink.AlikeSquared())) return {};
    const Vector2<S> across(-along.y(), along.x());
    step = kink.Lead(1) / length_sq * along;
    const S curvature = across.dot(kink.Hessian() * across);
    if (!(curvature > kEpsilon<S> * kink.Hessian().norm() * length_sq)) return {};
    step -= across.dot(kink.Gradient() + kink.Hessian() * step) / curvature * across;
  } else if (!kink.LevelThree(step)) {
    return {};
  }
  return kink.Take(step);
}

/// Newton's step with the origin inside of the set: downhill, regardless of the curvature.
/// @param reach  Longest step along which the pieces do not curve upwards, radians.
/// @param least  A step across two pieces that gains less than that is not taken, metres: all normals of a cone's side
///               are alike for an origin on its axis.
/// @return as StepOnKink(); its gain may be negative where the pieces are not level.
template <class S>
NormalStep<S> StepDownKink(const KinkModel<S>& kink, S reach, S least) {
  if (!kink.Hessian().allFinite()) return {};
  const Vector2<S>& gradient = kink.Gradient();
  const SquareMatrix<S, 2>& hessian = kink.Hessian();
  Vector2<S> step;
  if (kink.Size() == 1) {
    SquareMatrix<S, 2> inverse;
    if (hessian(0, 0) > 0 && hessian.determinant() > 0 && Invert(hessian, inverse)) {
      step = -inverse * gradient;
    } else {
      const S slope = gradient.norm();
      step = slope > 0 ? Vector2<S>(-reach / slope * gradient) : Vector2<S>(reach, 0);
    }
  } else if (kink.Size() == 2) {
    const Vector2<S> along = kink.Slope(1);
    const S length_sq = along.squaredNorm();
    if (!(length_sq > kink.AlikeSquared())) return {};
    const Vector2<S> across = Vector2<S>(-along.y(), along.x()) / std::sqrt(length_sq);
    step = kink.Lead(1) / length_sq * along;
    const S slope = across.dot(gradient + hessian * step), curvature = across.dot(hessian * across);
    const S length = std::abs(slope) < reach * curvature ? -slope / curvature : std::copysign(reach, -slope);
    if (-length * (slope + curvature * length / 2) > least) step += length * across;
  } else if (!kink.LevelThree(step)) {
    return {};
  }
  return kink.Take(step);
}

}  // namespace dgd
