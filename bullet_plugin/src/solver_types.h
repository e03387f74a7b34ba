// The solver's types as the plugin uses them: always double, in either precision of Bullet. The conversion costs a
// nanosecond, and a pose in float is exact in double, so the float trouble of Bullet's users (relative poses, tiny
// features) does not arise.
#pragma once

#include <cmath>

#include "dgd/query_types.h"
#include "dgd/types.h"

namespace dgd_bullet {

using Vector3 = dgd::Vector3<double>;
using Matrix3 = dgd::Matrix3<double>;
using Pose = dgd::Pose<double>;

/// Two shapes' contact, or the plane between them: `status`, `normal` (unit, from A to B, world), `separation` along it
/// (metres, negative for overlap), and a witness point on either shape (world). The bounds are the growth distance's,
/// and unknown where another stage has found the contact.
using Contact = dgd::Result<double>;

/// Whether a vector has unit length, but for roundoff in either precision; for assertions.
inline bool IsUnit(const Vector3& vector) { return std::abs(vector.squaredNorm() - 1) <= 1e-5; }

}  // namespace dgd_bullet
