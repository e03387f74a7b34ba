// A hash of a shape's content, by which a dispatcher finds that a shape has changed.
#pragma once

#include <LinearMath/btScalar.h>

#include <cstdint>

#include "dgd_bullet/linkage.h"

class btCollisionShape;
class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Differs for shapes of which one number differs. 0 for shapes that cannot be compared, and for those for which the
/// cached axis is not tried (pair/separating_axis.h).
std::uint64_t ContentHash(const btCollisionShape& shape);

/// Distance beyond which a core, a shape without its margin, has no point from its origin; metres.
btScalar CoreRadius(const btConvexShape& shape);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
