// Directions in space by the cells of a cube about the origin, whose faces are grids: near directions share a cell.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "dgd/types.h"

namespace dgd {

/// A table by direction has an entry for each cell; all cells of a face are squares of the same size.
template <class S>
class CubeMap {
 public:
  /// @param least_size  Cells that are wanted at least.
  explicit CubeMap(std::size_t least_size) {
    while (Size() < least_size) ++side_;
  }

  std::size_t Size() const { return 6 * side_ * side_; }

  /// The cell, below Size(), that a direction of any length points to; some cell if it is 0 or not finite.
  std::size_t CellOf(const Vector3<S>& direction) const {
    const Vector3<S> lengths = direction.cwiseAbs();
    std::size_t axis = lengths.y() > lengths.x() ? 1 : 0;
    if (lengths.z() > std::max(lengths.x(), lengths.y())) axis = 2;
    const S height = direction[Index(axis)], per_cell = S(0.5) * S(side_) / std::abs(height);
    const std::size_t face = 2 * axis + (height < 0 ? 1 : 0);
    const std::size_t row = Place(direction[Index((axis + 1) % 3)] * per_cell);
    return (face * side_ + row) * side_ + Place(direction[Index((axis + 2) % 3)] * per_cell);
  }

  /// A direction into the middle of a cell, of length 1 to sqrt(3).
  Vector3<S> MiddleOf(std::size_t cell) const {
    const std::size_t face = cell / (side_ * side_), axis = face / 2;
    const auto middle = [&](std::size_t place) { return (S(2) * S(place) + 1) / S(side_) - 1; };
    Vector3<S> direction;
    direction[Index(axis)] = face % 2 == 0 ? S(1) : S(-1);
    direction[Index((axis + 1) % 3)] = middle(cell / side_ % side_);
    direction[Index((axis + 2) % 3)] = middle(cell % side_);
    return direction;
  }

 private:
  static Eigen::Index Index(std::size_t axis) { return static_cast<Eigen::Index>(axis); }

  /// @param across  From the middle of the face, in cells.
  std::size_t Place(S across) const {
    // In this order 0 for NaN.
    const S place = std::max(S(0), std::min(S(0.5) * S(side_) + across, S(side_ - 1)));
    return static_cast<std::size_t>(place);
  }

  std::size_t side_ = 1;
};

}  // namespace dgd
