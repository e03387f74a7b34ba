// The loops compiled for AVX2.
#include "vertex_scan_loops.h"

namespace dgd::vertex_scan {

void PlaceAvx2(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
               double* placed) {
  PlaceAll(coordinates, padded, center, matrix, placed);
}

void PlaceAvx2(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed) {
  PlaceAll(coordinates, padded, center, matrix, placed);
}

std::uint32_t FarthestAvx2(const double* coordinates, std::size_t padded, double x, double y, double z) {
  return FarthestOf(coordinates, padded, x, y, z);
}

std::uint32_t FarthestAvx2(const float* coordinates, std::size_t padded, float x, float y, float z) {
  return FarthestOf(coordinates, padded, x, y, z);
}

}  // namespace dgd::vertex_scan
