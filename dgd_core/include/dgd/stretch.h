// By how much a linear map stretches what it maps.
#pragma once

#include "dgd/types.h"

namespace dgd {

/// Of all vectors of unit length, the images' greatest and least lengths: the largest and the smallest singular value.
struct Stretch {
  double most, least;
};

/// Of a finite matrix, to rounding. Not inline: a compiler takes long for the decomposition.
Stretch StretchOf(const SquareMatrix<double, 2>& linear);
Stretch StretchOf(const SquareMatrix<double, 3>& linear);

}  // namespace dgd
