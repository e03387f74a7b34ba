// The algebra of the second-order cone of four dimensions that an interior-point method works in.
//
// Vandenberghe 2010, "The CVXOPT linear and quadratic cone program solvers", Sec. 4 and 5: J = diag(1, -1, -1, -1),
// det(v) = v^T J v; product, inverse and division are those of the cone's Jordan algebra; W is the scaling point of
// Nesterov and Todd, for which W z = W^-1 s.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dgd/types.h"

namespace dgd_bench {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

/// J v.
inline Vector4 Reflected(const Vector4& v) { return {v[0], -v[1], -v[2], -v[3]}; }

/// v^T J v, without the cancellation of the two squares; > 0 within the cone.
inline double ConeDeterminant(const Vector4& v) {
  const double length = v.tail<3>().norm();
  return (v[0] - length) * (v[0] + length);
}

/// v o v.
inline Vector4 ConeSquare(const Vector4& v) {
  Vector4 square = 2 * v[0] * v;
  square[0] = v.squaredNorm();
  return square;
}

/// The x with v o x = right; v within the cone.
inline Vector4 ConeQuotient(const Vector4& right, const Vector4& v, double determinant) {
  Vector4 quotient;
  quotient[0] = Reflected(v).dot(right) / determinant;
  quotient.tail<3>() = (right.tail<3>() - quotient[0] * v.tail<3>()) / v[0];
  return quotient;
}

/// How many steps lead from v, within the cone, to its border; infinite if none do.
inline double StepsToConeBorder(const Vector4& v, double determinant, const Vector4& step) {
  // The first zero of det(v + t step), a parabola that is positive at 0 and has two real zeros: below 0 is rounding,
  // where a step leads through the tip.
  const double curvature = Reflected(step).dot(step);
  const double slope = Reflected(v).dot(step);
  const double root = std::sqrt(std::max(slope * slope - curvature * determinant, 0.0));
  if (slope <= 0) return determinant / (root - slope);
  return curvature < 0 ? (root + slope) / -curvature : std::numeric_limits<double>::infinity();
}

/// W, for two points within the cone.
class NesterovToddScaling {
 public:
  NesterovToddScaling() = default;
  NesterovToddScaling(const Vector4& s, double s_determinant, const Vector4& z, double z_determinant) {
    const double s_length = std::sqrt(s_determinant), z_length = std::sqrt(z_determinant);
    squared_size_ = s_length / z_length;
    size_ = std::sqrt(squared_size_);
    const Vector4 s_unit = s / s_length, z_unit = z / z_length;
    axis_ = (s_unit + Reflected(z_unit)) / std::sqrt(2 * (1 + s_unit.dot(z_unit)));
    // Its determinant is 1 but for rounding, which it is cleaned of.
    axis_[0] = std::sqrt(1 + axis_.tail<3>().squaredNorm());
  }

  /// W^-1 v.
  Vector4 InverseTimes(const Vector4& v) const {
    const double across = axis_.tail<3>().dot(v.tail<3>());
    Vector4 scaled;
    scaled[0] = (axis_[0] * v[0] - across) / size_;
    scaled.tail<3>() = (v.tail<3>() + (across / (1 + axis_[0]) - v[0]) * axis_.tail<3>()) / size_;
    return scaled;
  }

  /// W^-2.
  Matrix4 InverseSquared() const {
    const Vector4 axis = Reflected(axis_);
    Matrix4 square = (2 * axis) * axis.transpose();
    square(0, 0) -= 1;
    for (int i = 1; i < 4; ++i) square(i, i) += 1;
    return square / squared_size_;
  }

 private:
  Vector4 axis_ = Vector4::UnitX();
  double size_ = 1, squared_size_ = 1;
};

}  // namespace dgd_bench
