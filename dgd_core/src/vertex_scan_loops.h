// Internal: the loops of vertex_scan.h, which vertex_scan.cc and vertex_scan_avx2.cc each compile for their instruction
// set. Each operation is rounded once, without FMA, so that all processors find the same vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "dgd/shapes/vertex_scan_kernels.h"

namespace dgd::vertex_scan {
namespace {

// Vectors that are wider than the processor's are split by the compiler. They do not leave their file.
constexpr std::size_t kLaneBytes = 32;
template <class S>
using Lanes __attribute__((vector_size(kLaneBytes))) = S;
// Arrays of scalars are aligned as scalars.
template <class S>
inline Lanes<S> Load(const S* from) {
  Lanes<S> lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
template <class S>
inline void Store(const Lanes<S>& lanes, S* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}
template <class S>
inline Lanes<S> Broadcast(S value) {
  return value - Lanes<S>{};
}
/// The greater ones; of the second operand where either is not a number.
template <class S>
inline Lanes<S> Greater(const Lanes<S>& a, const Lanes<S>& b) {
  return a > b ? a : b;
}

/// The best of all lanes, by a choice of the better of two, in each lane.
template <class S, class Better>
inline Lanes<S> Fold(Lanes<S> lanes, const Better& better) {
  if constexpr (sizeof(S) == sizeof(double)) {
    lanes = better(lanes, __builtin_shufflevector(lanes, lanes, 2, 3, 0, 1));
    lanes = better(lanes, __builtin_shufflevector(lanes, lanes, 1, 0, 3, 2));
  } else {
    lanes = better(lanes, __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7, 0, 1, 2, 3));
    lanes = better(lanes, __builtin_shufflevector(lanes, lanes, 2, 3, 0, 1, 6, 7, 4, 5));
    lanes = better(lanes, __builtin_shufflevector(lanes, lanes, 1, 0, 3, 2, 5, 4, 7, 6));
  }
  return lanes;
}

/// Each lane keeps its greatest height and where that was; two chains hide the latency.
template <class S>
inline std::uint32_t FarthestOf(const S* x, std::size_t padded, S direction_x, S direction_y, S direction_z) {
  constexpr std::size_t kLanes = kLaneBytes / sizeof(S);
  static_assert(kBlockBytes % (2 * kLaneBytes) == 0);
  const S *y = x + padded, *z = y + padded;
  const auto heights = [&](std::size_t i) {
    return Load(x + i) * direction_x + Load(y + i) * direction_y + Load(z + i) * direction_z;
  };
  constexpr S kInfinity = std::numeric_limits<S>::infinity();
  Lanes<S> even = Broadcast(-kInfinity), odd = even, even_block{}, odd_block{}, block{};
  for (std::size_t i = 0; i < padded; i += 2 * kLanes) {
    const Lanes<S> a = heights(i), b = heights(i + kLanes);
    even_block = a > even ? block : even_block;
    odd_block = b > odd ? block : odd_block;
    even = Greater<S>(a, even);
    odd = Greater<S>(b, odd);
    block = block + S(2 * kLanes);
  }
  // The first of several points as high: copies in the padding, or a face that the direction is normal to.
  const Lanes<S> top = Fold<S>(Greater<S>(even, odd), Greater<S>), none = Broadcast(kInfinity);
  Lanes<S> lane;
  for (std::size_t i = 0; i < kLanes; ++i) lane[i] = S(i);
  const Lanes<S> even_place = even == top ? even_block + lane : none;
  const Lanes<S> odd_place = odd == top ? odd_block + (lane + S(kLanes)) : none;
  const auto lesser = [](const Lanes<S>& a, const Lanes<S>& b) -> Lanes<S> { return a < b ? a : b; };
  return static_cast<std::uint32_t>(Fold<S>(lesser(even_place, odd_place), lesser)[0]);
}

template <class S>
inline void PlaceAll(const S* x, std::size_t padded, const S* center, const S* matrix, S* placed) {
  // Read before the loop, which may write to where they are, as far as the compiler can see.
  const Lanes<S> center_x = Broadcast(center[0]), center_y = Broadcast(center[1]), center_z = Broadcast(center[2]);
  Lanes<S> m[9];
  for (std::size_t i = 0; i < 9; ++i) m[i] = Broadcast(matrix[i]);
  for (std::size_t i = 0; i < padded; i += kLaneBytes / sizeof(S)) {
    const Lanes<S> from_x = Load(x + i) - center_x, from_y = Load(x + padded + i) - center_y,
                   from_z = Load(x + 2 * padded + i) - center_z;
    for (std::size_t row = 0; row < 3; ++row) {
      Store<S>(m[row] * from_x + m[3 + row] * from_y + m[6 + row] * from_z, placed + row * padded + i);
    }
  }
}

}  // namespace
}  // namespace dgd::vertex_scan
