// Newton's step towards the normal along which a convex set made of smooth pieces is nearest to an origin outside of
// it, where that normal may be on a kink between pieces: as an edge of a box on the side of a cylinder.
//
// The support function is the largest of the pieces' own. Of two or three pieces that are level at the minimum, each
// with gradient g_i and Hessian H_i - h I across the normal (normal_step.h), a step s keeps them level,
//
//     h_1 + <g_1, s> = h_i + <g_i, s>,
//
// and has the least value of their Lagrangian, of which the weights are those of the pieces' points in the point of
// their simplex that is nearest to the origin: sequential quadratic programming.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "dgd/assert.h"
#include "dgd/invert.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// One piece's support function about a unit normal. All vectors are in one frame, about the origin that is meant.
template <class S>
struct PieceModel {
  Vector3<S> point;              ///< The piece's support point along the normal, metres.
  SquareMatrix<S, 2> curvature;  ///< How it moves with the normal, along two tangents; metres.
  S weight;                      ///< Of the piece; all sum up to 1.
};

/// Up to three pieces.
template <class S>
struct PieceModels {
  std::array<PieceModel<S>, 3> models;
  std::size_t size = 0;

  const PieceModel<S>& operator[](std::size_t i) const { return models[i]; }
  PieceModel<S>& operator[](std::size_t i) { return models[i]; }
};

/// @param normal    Unit length.
/// @param tangents  Rows: two unit vectors across `normal` and across each other.
/// @param pieces    At least one.
/// @param next      Out: the next normal, unit length.
/// @return false if the pieces' points are in line with the normal, or alike, or if a support function has no second
///         derivative there.
template <class S>
bool StepOnKink(const Vector3<S>& normal, const Eigen::Matrix<S, 2, 3>& tangents, const PieceModels<S>& pieces,
                Vector3<S>& next) {
  DGD_ASSERT(pieces.size >= 1 && pieces.size <= pieces.models.size() && IsUnitOrNan(normal));
  const PieceModel<S>& first = pieces[0];
  Vector2<S> gradient = Vector2<S>::Zero();
  SquareMatrix<S, 2> hessian = SquareMatrix<S, 2>::Zero();
  for (std::size_t i = 0; i < pieces.size; ++i) {
    const PieceModel<S>& piece = pieces[i];
    gradient += piece.weight * (tangents * piece.point);
    hessian += piece.weight * (piece.curvature - normal.dot(piece.point) * SquareMatrix<S, 2>::Identity());
  }
  // Along a rim's axis, it has none.
  if (!hessian.allFinite()) return false;
  // Across the normal, and along it.
  const auto slope = [&](std::size_t i) -> Vector2<S> { return tangents * (pieces[i].point - first.point); };
  const auto lead = [&](std::size_t i) -> S { return normal.dot(first.point - pieces[i].point); };
  // Points that are no farther apart are alike but for roundoff.
  const S alike_sq = kEpsilon<S> * kEpsilon<S> * first.point.squaredNorm();
  Vector2<S> step;
  if (pieces.size == 1) {
    SquareMatrix<S, 2> inverse;
    if (!Invert(hessian, inverse)) return false;
    step = -inverse * gradient;
  } else if (pieces.size == 2) {
    const Vector2<S> a = slope(1);
    const S length_sq = a.squaredNorm();
    if (!(length_sq > alike_sq)) return false;
    const Vector2<S> across(-a.y(), a.x());
    step = lead(1) / length_sq * a;
    const S curvature = across.dot(hessian * across);
    if (!(curvature > kEpsilon<S> * hessian.norm() * length_sq)) return false;
    step -= across.dot(gradient + hessian * step) / curvature * across;
  } else {
    SquareMatrix<S, 2> slopes;
    slopes << slope(1).transpose(), slope(2).transpose();
    SquareMatrix<S, 2> inverse;
    if (!(std::abs(slopes.determinant()) > alike_sq) || !Invert(slopes, inverse)) return false;
    step = inverse * Vector2<S>(lead(1), lead(2));
  }
  const S length = step.norm();
  if (!std::isfinite(length)) return false;
  // Not beyond 45 degrees: the model is one of the normal's surroundings.
  if (length > 1) step /= length;
  next = (normal + tangents.transpose() * step).normalized();
  return true;
}

}  // namespace dgd
