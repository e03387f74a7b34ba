// The loops on what every x86-64 has, and the choice of the best ones.
#include <emmintrin.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

#include "dgd/shapes/vertex_scan_kernels.h"

namespace dgd::vertex_scan {
namespace {

/// Points scanned at once: their heights stay on the stack until the highest one's place is known. As many as a mask
/// has bits.
constexpr std::size_t kChunk = 64;

template <class S>
using Lanes __attribute__((vector_size(16))) = S;
/// Unaligned, and allowed to alias the scalars that it reads.
template <class S>
using LoadLanes __attribute__((vector_size(16), aligned(alignof(S)), may_alias)) = S;

/// A bit per lane of a block that equals the value, the first lane's lowest.
template <class S>
std::uint64_t LanesEqualTo(S value, const Lanes<S>* block) {
  const Lanes<S> values = value - Lanes<S>{};
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

template <class S>
std::uint32_t FarthestOf(const S* x, std::size_t padded, S direction_x, S direction_y, S direction_z) {
  constexpr std::size_t kLanes = 16 / sizeof(S);
  const auto load = [](const S* array) { return Lanes<S>(*reinterpret_cast<const LoadLanes<S>*>(array)); };
  const S* y = x + padded;
  const S* z = y + padded;
  const Lanes<S> dx = direction_x - Lanes<S>{}, dy = direction_y - Lanes<S>{}, dz = direction_z - Lanes<S>{};

  S highest = -std::numeric_limits<S>::infinity();
  std::size_t farthest = 0;
  Lanes<S> heights[kChunk / kLanes];
  for (std::size_t begin = 0; begin < padded; begin += kChunk) {
    // First the greatest height of the chunk, which vectors find without a branch; then where it was.
    const std::size_t vectors = std::min(kChunk, padded - begin) / kLanes;
    Lanes<S> even = highest - Lanes<S>{};
    Lanes<S> odd = even;
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
    for (std::size_t i = 0; i < vectors; i += 2) at_top |= LanesEqualTo<S>(top, &heights[i]) << (i * kLanes);
    farthest = begin + static_cast<std::size_t>(std::countr_zero(at_top));
  }
  return static_cast<std::uint32_t>(farthest);
}

template <class S>
void PlaceAll(const S* x, std::size_t padded, const S* center, const S* matrix, S* placed) {
  constexpr std::size_t kLanes = 16 / sizeof(S);
  const auto load = [](const S* array) { return Lanes<S>(*reinterpret_cast<const LoadLanes<S>*>(array)); };
  for (std::size_t i = 0; i < padded; i += kLanes) {
    const Lanes<S> from_x = load(x + i) - center[0], from_y = load(x + padded + i) - center[1],
                   from_z = load(x + 2 * padded + i) - center[2];
    for (std::size_t row = 0; row < 3; ++row) {
      const Lanes<S> sum = matrix[row] * from_x + matrix[3 + row] * from_y + matrix[6 + row] * from_z;
      *reinterpret_cast<LoadLanes<S>*>(placed + row * padded + i) = sum;
    }
  }
}

/// The kernels in use, chosen by the first call: a query before main() finds valid ones, too.
template <class S>
struct Best {
  static std::uint32_t ChooseFarthest(const S* coordinates, std::size_t padded, S x, S y, S z) {
    const FarthestKernel<S> avx2 = FarthestAvx2, sse2 = FarthestSse2;
    const FarthestKernel<S> best = HasAvx2() ? avx2 : sse2;
    farthest.store(best, std::memory_order_relaxed);
    return best(coordinates, padded, x, y, z);
  }
  static void ChoosePlace(const S* coordinates, std::size_t padded, const S* center, const S* matrix, S* placed) {
    const PlaceKernel<S> avx2 = PlaceAvx2, sse2 = PlaceSse2;
    const PlaceKernel<S> best = HasAvx2() ? avx2 : sse2;
    place.store(best, std::memory_order_relaxed);
    best(coordinates, padded, center, matrix, placed);
  }

  static constinit inline std::atomic<FarthestKernel<S>> farthest = &ChooseFarthest;
  static constinit inline std::atomic<PlaceKernel<S>> place = &ChoosePlace;
};

}  // namespace

std::uint32_t FarthestSse2(const double* coordinates, std::size_t padded, double x, double y, double z) {
  return FarthestOf(coordinates, padded, x, y, z);
}

std::uint32_t FarthestSse2(const float* coordinates, std::size_t padded, float x, float y, float z) {
  return FarthestOf(coordinates, padded, x, y, z);
}

void PlaceSse2(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
               double* placed) {
  PlaceAll(coordinates, padded, center, matrix, placed);
}

void PlaceSse2(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed) {
  PlaceAll(coordinates, padded, center, matrix, placed);
}

bool HasAvx2() { return __builtin_cpu_supports("avx2") != 0; }

std::uint32_t Farthest(const double* coordinates, std::size_t padded, double x, double y, double z) {
  return Best<double>::farthest.load(std::memory_order_relaxed)(coordinates, padded, x, y, z);
}

std::uint32_t Farthest(const float* coordinates, std::size_t padded, float x, float y, float z) {
  return Best<float>::farthest.load(std::memory_order_relaxed)(coordinates, padded, x, y, z);
}

void Place(const double* coordinates, std::size_t padded, const double* center, const double* matrix, double* placed) {
  Best<double>::place.load(std::memory_order_relaxed)(coordinates, padded, center, matrix, placed);
}

void Place(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed) {
  Best<float>::place.load(std::memory_order_relaxed)(coordinates, padded, center, matrix, placed);
}

}  // namespace dgd::vertex_scan
