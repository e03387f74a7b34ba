// Newton's step towards the normal along which a smooth convex set is nearest to the origin.
//
// On the unit sphere the support function h(n) has the gradient p - h n, p the support point along n, and the Hessian
// H - h I across n, H = dp/dn. With the origin outside h is negative near the best normal, and the Hessian positive
// definite; with the origin inside it is so where the surface curves less than a sphere of radius h, as it must at a
// local minimum.
#pragma once

#include <cmath>

#include "dgd/assert.h"
#include "dgd/types.h"

namespace dgd {

template <class S>
struct NormalStep {
  bool is_valid = false;  ///< False where the Hessian is not positive definite: the rest is meaningless then.
  Vector3<S> next;        ///< The next normal, unit length.
  S gain;                 ///< Fall of h, by the model; metres.
};

/// @param point      Support point along the unit vector `normal`; metres.
/// @param tangents   Rows: two unit vectors across `normal` and across each other.
/// @param curvature  H along these, metres.
template <class S>
NormalStep<S> StepFrom(const Vector3<S>& normal, const Vector3<S>& point, const Eigen::Matrix<S, 2, 3>& tangents,
                       const SquareMatrix<S, 2>& curvature) {
  DGD_ASSERT(IsUnitOrNan(normal));
  NormalStep<S> result;
  const SquareMatrix<S, 2> hessian = curvature - normal.dot(point) * SquareMatrix<S, 2>::Identity();
  const S determinant = hessian(0, 0) * hessian(1, 1) - hessian(0, 1) * hessian(1, 0);
  // Comparisons that raise nothing for NaN: pieces without a derivative are nothing unusual.
  if (!(std::isgreater(determinant, S(0)) && std::isgreater(hessian(0, 0), S(0)) && std::isfinite(determinant))) {
    return result;
  }
  const Vector2<S> gradient = tangents * point;
  Vector2<S> step(hessian(0, 1) * gradient.y() - hessian(1, 1) * gradient.x(),
                  hessian(1, 0) * gradient.x() - hessian(0, 0) * gradient.y());
  step /= determinant;
  result.is_valid = true;
  result.gain = -gradient.dot(step) / 2;
  // Not beyond 45 degrees: the model is one of the normal's surroundings.
  const S length = step.norm();
  if (length > 1) step /= length;
  result.next = (normal + tangents.transpose() * step).normalized();
  return result;
}

}  // namespace dgd
