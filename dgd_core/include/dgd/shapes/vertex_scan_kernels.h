// Internal: the loops of vertex_scan.h for each instruction set. Compiled apart, and from nothing that other
// translation units instantiate too: a template or inline function compiled for AVX2 must not end up where the
// processor has none.
#pragma once

#include <cstddef>
#include <cstdint>

#include "dgd/export.h"

namespace dgd::vertex_scan {

/// Bytes of one coordinate that the widest kernel reads in a step: the arrays are padded to a multiple.
inline constexpr std::size_t kBlockBytes = 64;

/// Index of the point with the greatest x * direction_x + y * direction_y + z * direction_z, summed in this order, each
/// operation rounded; the first one of several. 0 where no height is a number. All kernels give the same index.
/// @param coordinates  Three arrays one after the other, of `padded` scalars each; no alignment needed.
/// @param padded       A multiple of kBlockBytes / sizeof(scalar), > 0; in float below 2^24, up to which it counts.
template <class S>
using FarthestKernel = std::uint32_t (*)(const S* coordinates, std::size_t padded, S x, S y, S z);

std::uint32_t FarthestSse2(const double* coordinates, std::size_t padded, double x, double y, double z);
std::uint32_t FarthestSse2(const float* coordinates, std::size_t padded, float x, float y, float z);

/// The same for processors with HasAvx2().
std::uint32_t FarthestAvx2(const double* coordinates, std::size_t padded, double x, double y, double z);
std::uint32_t FarthestAvx2(const float* coordinates, std::size_t padded, float x, float y, float z);

/// Moves points: `matrix`, 3 x 3 by columns, times what each is from `center`; each operation rounded, the columns'
/// products summed in their order. All kernels give the same bits.
/// @param coordinates, padded  As above.
/// @param placed               Out: as the coordinates.
template <class S>
using PlaceKernel = void (*)(const S* coordinates, std::size_t padded, const S* center, const S* matrix, S* placed);

void PlaceSse2(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
               double* placed);
void PlaceSse2(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed);

/// The same for processors with HasAvx2().
void PlaceAvx2(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
               double* placed);
void PlaceAvx2(const float* coordinates, std::size_t padded, const float* center, const float* matrix, float* placed);

/// Whether this processor, and the system on it, can run AVX2.
bool HasAvx2();

/// The best kernels for this processor.
DGD_EXPORT std::uint32_t Farthest(const double* coordinates, std::size_t padded, double x, double y, double z);
DGD_EXPORT std::uint32_t Farthest(const float* coordinates, std::size_t padded, float x, float y, float z);
DGD_EXPORT void Place(const double* coordinates, std::size_t padded, const double* center, const double* matrix,
                      double* placed);
DGD_EXPORT void Place(const float* coordinates, std::size_t padded, const float* center, const float* matrix,
                      float* placed);

}  // namespace dgd::vertex_scan
