// The inverse of a small matrix, if it has one.
#pragma once

#include <cmath>
#include <limits>

#include "dgd/types.h"

namespace dgd {

/// Inverse by the determinant, without dividing by one that is 0, too small, or not a number: nothing is raised then.
/// @param inverse  Out; left as it was where the matrix has none.
/// @return false for a singular matrix.
template <class S>
bool Invert(const SquareMatrix<S, 1>& matrix, SquareMatrix<S, 1>& inverse) {
  if (!std::isgreaterequal(std::abs(matrix(0, 0)), std::numeric_limits<S>::min())) return false;
  inverse(0, 0) = 1 / matrix(0, 0);
  return true;
}

template <class S>
bool Invert(const SquareMatrix<S, 2>& matrix, SquareMatrix<S, 2>& inverse) {
  const S determinant = matrix(0, 0) * matrix(1, 1) - matrix(1, 0) * matrix(0, 1);
  if (!std::isgreaterequal(std::abs(determinant), std::numeric_limits<S>::min())) return false;
  const S scale = 1 / determinant;
  inverse << matrix(1, 1) * scale, -matrix(0, 1) * scale, -matrix(1, 0) * scale, matrix(0, 0) * scale;
  return true;
}

template <class S>
bool Invert(const SquareMatrix<S, 3>& matrix, SquareMatrix<S, 3>& inverse) {
  const Vector3<S> first = matrix.col(1).cross(matrix.col(2));
  const S determinant = matrix.col(0).dot(first);
  if (!std::isgreaterequal(std::abs(determinant), std::numeric_limits<S>::min())) return false;
  inverse << first.transpose(), matrix.col(2).cross(matrix.col(0)).transpose(),
      matrix.col(0).cross(matrix.col(1)).transpose();
  inverse /= determinant;
  return true;
}

}  // namespace dgd
