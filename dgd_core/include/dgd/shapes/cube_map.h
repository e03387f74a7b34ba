// Directions in space by the cells of a cube about the origin, whose faces are grids: near directions share a cell.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "dgd/types.h"

namespace dgd {

/// A table by direction has an entry for each cell; all cells of a face are squares of the same size.
template <class S>
class CubeMap {
 public:
  /// @param least_size  Cells that are wanted at least; below 2^31.
  explicit CubeMap(std::size_t least_size) {
    while (Size() < least_size) ++side_;
    half_side_ = S(0.5) * S(side_);
    last_place_ = S(side_ - 1);
  }

  std::size_t Size() const { return std::size_t(6) * side_ * side_; }

  /// The cell, below Size(), that a direction of any length points to; some cell if it is 0 or not finite.
  std::size_t CellOf(const Vector3<S>& direction) const {
    constexpr std::array<int, 3> kNext = {1, 2, 0}, kPrevious = {2, 0, 1};
    const S x = std::abs(direction.x()), y = std::abs(direction.y()), z = std::abs(direction.z());
    const bool is_above_x = y > x;
    const unsigned axis = z > (is_above_x ? y : x) ? 2U : is_above_x ? 1U : 0U;
    const S height = direction[static_cast<int>(axis)], per_cell = half_side_ / std::abs(height);
    const unsigned face = 2 * axis + (height < 0 ? 1U : 0U);
    const unsigned row = Place(direction[kNext[axis]] * per_cell);
    return (face * side_ + row) * side_ + Place(direction[kPrevious[axis]] * per_cell);
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
  unsigned Place(S across) const {
    // This order gives the last one for NaN, without a branch.
    S place = half_side_ + across;
    place = place < last_place_ ? place : last_place_;
    place = place > 0 ? place : S(0);
    return static_cast<unsigned>(static_cast<int>(place));
  }

  unsigned side_ = 1;
  S half_side_ = S(0.5), last_place_ = 0;
};

}  // namespace dgd
