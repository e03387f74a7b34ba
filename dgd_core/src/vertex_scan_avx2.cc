// Compiled for AVX2, without FMA: one roundoff per operation, so that all processors find the same vertices.
#include <immintrin.h>

#include "dgd/shapes/vertex_scan_kernels.h"

namespace dgd::vertex_scan {
namespace {

// What the two scalars' vectors are called. Static members of a local type: nothing here leaves this file.
struct Doubles {
  using Scalar = double;
  using Vector = __m256d;
  static constexpr std::size_t kLanes = 4;

  static Vector Load(const double* from) { return _mm256_loadu_pd(from); }
  static void Store(double* to, Vector a) { _mm256_storeu_pd(to, a); }
  static Vector Broadcast(double a) { return _mm256_set1_pd(a); }
  static Vector CountUp() { return _mm256_setr_pd(0, 1, 2, 3); }
  static Vector Add(Vector a, Vector b) { return _mm256_add_pd(a, b); }
  static Vector Subtract(Vector a, Vector b) { return _mm256_sub_pd(a, b); }
  static Vector Multiply(Vector a, Vector b) { return _mm256_mul_pd(a, b); }
  // The second one if either is not finite.
  static Vector Greater(Vector a, Vector b) { return _mm256_max_pd(a, b); }
  static Vector IsAbove(Vector a, Vector b) { return _mm256_cmp_pd(a, b, _CMP_GT_OQ); }
  static Vector Choose(Vector no, Vector yes, Vector mask) { return _mm256_blendv_pd(no, yes, mask); }
  static Vector IsEqual(Vector a, Vector b) { return _mm256_cmp_pd(a, b, _CMP_EQ_OQ); }
  static Vector Less(Vector a, Vector b) { return _mm256_min_pd(a, b); }
  // The greatest lane in all lanes.
  static Vector Top(Vector a) {
    a = _mm256_max_pd(a, _mm256_permute2f128_pd(a, a, 1));  // Halves change places.
    return _mm256_max_pd(a, _mm256_permute_pd(a, 0b0101));  // Neighbours change places.
  }
  // The least lane.
  static double Least(Vector a) {
    const __m128d half = _mm_min_pd(_mm256_castpd256_pd128(a), _mm256_extractf128_pd(a, 1));
    return _mm_cvtsd_f64(_mm_min_sd(half, _mm_unpackhi_pd(half, half)));
  }
};

struct Floats {
  using Scalar = float;
  using Vector = __m256;
  static constexpr std::size_t kLanes = 8;

  static Vector Load(const float* from) { return _mm256_loadu_ps(from); }
  static void Store(float* to, Vector a) { _mm256_storeu_ps(to, a); }
  static Vector Broadcast(float a) { return _mm256_set1_ps(a); }
  static Vector CountUp() { return _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7); }
  static Vector Add(Vector a, Vector b) { return _mm256_add_ps(a, b); }
  static Vector Subtract(Vector a, Vector b) { return _mm256_sub_ps(a, b); }
  static Vector Multiply(Vector a, Vector b) { return _mm256_mul_ps(a, b); }
  static Vector Greater(Vector a, Vector b) { return _mm256_max_ps(a, b); }
  static Vector IsAbove(Vector a, Vector b) { return _mm256_cmp_ps(a, b, _CMP_GT_OQ); }
  static Vector Choose(Vector no, Vector yes, Vector mask) { return _mm256_blendv_ps(no, yes, mask); }
  static Vector IsEqual(Vector a, Vector b) { return _mm256_cmp_ps(a, b, _CMP_EQ_OQ); }
  static Vector Less(Vector a, Vector b) { return _mm256_min_ps(a, b); }
  static Vector Top(Vector a) {
    a = _mm256_max_ps(a, _mm256_permute2f128_ps(a, a, 1));         // Halves change places,
    a = _mm256_max_ps(a, _mm256_permute_ps(a, 0b01'00'11'10));     // pairs,
    return _mm256_max_ps(a, _mm256_permute_ps(a, 0b10'11'00'01));  // then neighbours.
  }
  static float Least(Vector a) {
    __m128 least = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
    least = _mm_min_ps(least, _mm_movehl_ps(least, least));
    return _mm_cvtss_f32(_mm_min_ss(least, _mm_movehdup_ps(least)));
  }
};

// Each lane keeps its greatest height and where that was; two chains hide the latency.
template <class V>
std::uint32_t FarthestOf(const typename V::Scalar* coordinates, std::size_t padded, typename V::Scalar x,
                         typename V::Scalar y, typename V::Scalar z) {
  using S = typename V::Scalar;
  using Vector = typename V::Vector;
  constexpr std::size_t kLanes = V::kLanes;
  const Vector dx = V::Broadcast(x), dy = V::Broadcast(y), dz = V::Broadcast(z);
  const auto heights = [&](std::size_t i) {
    const Vector across =
        V::Add(V::Multiply(V::Load(coordinates + i), dx), V::Multiply(V::Load(coordinates + padded + i), dy));
    return V::Add(across, V::Multiply(V::Load(coordinates + 2 * padded + i), dz));
  };
  const Vector lowest = V::Broadcast(-__builtin_huge_val());
  Vector even = lowest, odd = lowest, even_block = V::Broadcast(0), odd_block = even_block, block = even_block;
  const Vector next = V::Broadcast(2 * kLanes);
  for (std::size_t i = 0; i < padded; i += 2 * kLanes) {
    const Vector a = heights(i), b = heights(i + kLanes);
    even_block = V::Choose(even_block, block, V::IsAbove(a, even));
    odd_block = V::Choose(odd_block, block, V::IsAbove(b, odd));
    even = V::Greater(a, even);
    odd = V::Greater(b, odd);
    block = V::Add(block, next);
  }

  // The first of several points as high: copies in the padding, or a face that the direction is normal to.
  const Vector top = V::Top(V::Greater(even, odd)), none = V::Broadcast(__builtin_huge_val());
  const Vector even_place = V::Choose(none, V::Add(even_block, V::CountUp()), V::IsEqual(even, top));
  const Vector odd_place =
      V::Choose(none, V::Add(odd_block, V::Add(V::CountUp(), V::Broadcast(kLanes))), V::IsEqual(odd, top));
  const S first = V::Least(V::Less(even_place, odd_place));
  return static_cast<std::uint32_t>(first);
}

template <class V>
void PlaceAll(const typename V::Scalar* coordinates, std::size_t padded, const typename V::Scalar* center,
              const typename V::Scalar* matrix, typename V::Scalar* placed) {
  using Vector = typename V::Vector;
  const Vector center_x = V::Broadcast(center[0]), center_y = V::Broadcast(center[1]),
               center_z = V::Broadcast(center[2]);
  Vector m[9];
  for (int i = 0; i < 9; ++i) m[i] = V::Broadcast(matrix[i]);
  for (std::size_t i = 0; i < padded; i += V::kLanes) {
    const Vector x = V::Subtract(V::Load(coordinates + i), center_x);
    const Vector y = V::Subtract(V::Load(coordinates + padded + i), center_y);
    const Vector z = V::Subtract(V::Load(coordinates + 2 * padded + i), center_z);
    for (int row = 0; row < 3; ++row) {
      const Vector across = V::Add(V::Multiply(m[row], x), V::Multiply(m[3 + row], y));
      V::Store(placed + static_cast<std::size_t>(row) * padded + i, V::Add(across, V::Multiply(m[6 + row], z)));
    }
  }
}

}  // namespace

void PlaceAvx2(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
               double* placed) {
  PlaceAll<Doubles>(coordinates, padded, center, matrix, placed);
}

void PlaceAvx2(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed) {
  PlaceAll<Floats>(coordinates, padded, center, matrix, placed);
}

std::uint32_t FarthestAvx2(const double* coordinates, std::size_t padded, double x, double y, double z) {
  return FarthestOf<Doubles>(coordinates, padded, x, y, z);
}

std::uint32_t FarthestAvx2(const float* coordinates, std::size_t padded, float x, float y, float z) {
  return FarthestOf<Floats>(coordinates, padded, x, y, z);
}

}  // namespace dgd::vertex_scan
