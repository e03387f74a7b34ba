// Index of the point farthest along a direction, among points stored by coordinate.
#pragma once

#include <cstddef>
#include <vector>

#include "dgd/types.h"

namespace dgd {

/// Points as three arrays, padded with copies of the first point to whole blocks, so that a scan needs no remainder.
template <class S>
class PointArrays {
 public:
  /// Lanes of a 16-byte vector, which every x86-64 has, times two independent chains that hide its latency.
  static constexpr std::size_t kLanes = 16 / sizeof(S);
  static constexpr std::size_t kBlock = 2 * kLanes;

  template <class Range>
  explicit PointArrays(const Range& points)
      : size_(points.size()), padded_((size_ + kBlock - 1) / kBlock * kBlock), coordinates_(3 * padded_) {
    for (std::size_t i = 0; i < padded_; ++i) {
      const auto& point = points[i < size_ ? i : 0];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        coordinates_[axis * padded_ + i] = static_cast<S>(point[static_cast<Eigen::Index>(axis)]);
      }
    }
  }

  std::size_t size() const { return size_; }

  Vector3<S> operator[](std::size_t i) const {
    return {coordinates_[i], coordinates_[padded_ + i], coordinates_[2 * padded_ + i]};
  }

  /// The first point of largest <direction, x> in its lane; one of the points also if the direction is NaN.
  VertexId Farthest(const Vector3<S>& direction) const;

 private:
  std::size_t size_;
  std::size_t padded_;
  std::vector<S> coordinates_;
};

template <class S>
VertexId PointArrays<S>::Farthest(const Vector3<S>& direction) const {
  using Index = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;
  typedef S Lanes __attribute__((vector_size(16)));
  typedef Index IndexLanes __attribute__((vector_size(16)));
  // Unaligned, and allowed to alias the scalars that it reads.
  typedef S LoadLanes __attribute__((vector_size(16), aligned(alignof(S)), may_alias));

  const S* x = coordinates_.data();
  const S* y = x + padded_;
  const S* z = y + padded_;
  const Lanes dx = direction.x() - Lanes{};
  const Lanes dy = direction.y() - Lanes{};
  const Lanes dz = direction.z() - Lanes{};
  const auto heights = [&](std::size_t i) {
    const auto load = [i](const S* array) { return Lanes(*reinterpret_cast<const LoadLanes*>(array + i)); };
    return load(x) * dx + load(y) * dy + load(z) * dz;
  };

  Lanes best_a = heights(0);
  Lanes best_b = heights(kLanes);
  // Block numbers of the best of each lane; the lane itself is added at the end.
  IndexLanes block_a{}, block_b{}, block{};
  for (std::size_t i = kBlock; i < padded_; i += kBlock) {
    block += 1;
    const Lanes a = heights(i);
    const Lanes b = heights(i + kLanes);
    const IndexLanes better_a = a > best_a;
    const IndexLanes better_b = b > best_b;
    best_a = better_a ? a : best_a;
    best_b = better_b ? b : best_b;
    block_a = better_a ? block : block_a;
    block_b = better_b ? block : block_b;
  }

  S best = best_a[0];
  std::size_t farthest = static_cast<std::size_t>(block_a[0]) * kBlock;
  const auto reduce = [&](const Lanes& lanes, const IndexLanes& blocks, std::size_t offset) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (lanes[lane] > best) {
        best = lanes[lane];
        farthest = static_cast<std::size_t>(blocks[lane]) * kBlock + offset + lane;
      }
    }
  };
  reduce(best_a, block_a, 0);
  reduce(best_b, block_b, kLanes);
  return static_cast<VertexId>(farthest < size_ ? farthest : 0);
}

}  // namespace dgd
