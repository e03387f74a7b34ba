// The greatest and the least stretch of a linear map.
#pragma once

#include "dgd/types.h"

namespace dgd_test {

/// The greatest and the least length that a vector of unit length is given: the largest and the smallest singular
/// value. Dimensionless, most >= least >= 0.
struct Stretch {
  double most, least;
};

/// Stretch by singular value decomposition, right to some last digits of `most`. Not inline: the decomposition takes a
/// compiler 2 seconds in each file that has it.
/// @param linear  Finite.
/// Does not allocate or throw.
Stretch StretchOf(const dgd::SquareMatrix<double, 2>& linear);
Stretch StretchOf(const dgd::SquareMatrix<double, 3>& linear);

}  // namespace dgd_test
