// A hash of a shape's content, by which a dispatcher finds that a shape has changed.
#pragma once

#include <cstdint>

#include "dgd_bullet/linkage.h"

class btCollisionShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Differs for certain between shapes of which one number differs, and but for one chance in 2^64 between those of
/// which more do. 0 for shapes that cannot be compared, and for those for which the cached axis is not tried
/// (pair/separating_axis.h).
std::uint64_t ContentHash(const btCollisionShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
