// Index of the point farthest along a direction, among points stored by coordinate.
#pragma once

#include <emmintrin.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
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

  /// A point of largest <direction, x>; some point if the direction is NaN.
  VertexId Farthest(const Vector3<S>& direction) const;

 private:
  typedef S Lanes __attribute__((vector_size(16)));

  /// Points scanned at once: their heights stay on the stack until the highest one's place is known. As many as a mask
  /// has bits.
  static constexpr std::size_t kChunk = 64;

  /// A bit per lane of a block that equals the value, the first lane's lowest.
  static std::uint64_t LanesEqualTo(S value, const Lanes* block) {
    const Lanes values = value - Lanes{};
    if constexpr (sizeof(S) == sizeof(double)) {
      const __m128 low = _mm_castpd_ps(_mm_cmpeq_pd(block[0], values));
      const __m128 high = _mm_castpd_ps(_mm_cmpeq_pd(block[1], values));
      return static_cast<std::uint64_t>(_mm_movemask_ps(_mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0))));
    } else {
      const __m128i low = _mm_castps_si128(_mm_cmpeq_ps(block[0], values));
      const __m128i high = _mm_castps_si128(_mm_cmpeq_ps(block[1], values));
      const __m128i halves = _mm_packs_epi32(low, high);
      return static_cast<std::uint64_t>(_mm_movemask_epi8(_mm_packs_epi16(halves, _mm_setzero_si128())));
    }
  }

  std::size_t size_;
  std::size_t padded_;
  std::vector<S> coordinates_;
};

template <class S>
VertexId PointArrays<S>::Farthest(const Vector3<S>& direction) const {
  // Unaligned, and allowed to alias the scalars that it reads.
  typedef S LoadLanes __attribute__((vector_size(16), aligned(alignof(S)), may_alias));
  const auto load = [](const S* array) { return Lanes(*reinterpret_cast<const LoadLanes*>(array)); };

  const S* x = coordinates_.data();
  const S* y = x + padded_;
  const S* z = y + padded_;
  const Lanes dx = direction.x() - Lanes{};
  const Lanes dy = direction.y() - Lanes{};
  const Lanes dz = direction.z() - Lanes{};

  S highest = -std::numeric_limits<S>::infinity();
  std::size_t farthest = 0;
  Lanes heights[kChunk / kLanes];
  for (std::size_t begin = 0; begin < padded_; begin += kChunk) {
    // First the greatest height of the chunk, which vectors find without a branch; then where it was.
    const std::size_t vectors = std::min(kChunk, padded_ - begin) / kLanes;
    Lanes even = highest - Lanes{};
    Lanes odd = even;
    for (std::size_t i = 0; i < vectors; i += 2) {
      const std::size_t a = begin + i * kLanes, b = a + kLanes;
      heights[i] = load(x + a) * dx + load(y + a) * dy + load(z + a) * dz;
      heights[i + 1] = load(x + b) * dx + load(y + b) * dy + load(z + b) * dz;
      even = heights[i] > even ? heights[i] : even;
      odd = heights[i + 1] > odd ? heights[i + 1] : odd;
    }
    even = even > odd ? even : odd;
    S top = even[0];
    for (std::size_t lane = 1; lane < kLanes; ++lane) top = even[lane] > top ? even[lane] : top;
    if (!(top > highest)) continue;
    highest = top;
    // As a mask: where a search would stop is what no branch predictor knows.
    std::uint64_t at_top = 0;
    for (std::size_t i = 0; i < vectors; i += 2) at_top |= LanesEqualTo(top, &heights[i]) << (i * kLanes);
    farthest = begin + static_cast<std::size_t>(std::countr_zero(at_top));
  }
  return static_cast<VertexId>(farthest < size_ ? farthest : 0);
}

}  // namespace dgd
