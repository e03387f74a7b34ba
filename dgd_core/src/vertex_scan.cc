// The loops on what every x86-64 has, and the choice of the best ones.
#include <atomic>

#include "vertex_scan_loops.h"

namespace dgd::vertex_scan {
namespace {

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
