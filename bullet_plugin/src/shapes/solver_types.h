// The solver's types as the plugin uses them: always double, whatever Bullet's precision. The conversion costs a
// nanosecond, and a pose in float is exact in double, so what Bullet users know as float trouble (relative poses, tiny
// features) does not arise.
#pragma once

#include "dgd/types.h"

namespace dgd_bullet {

using Vector3 = dgd::Vector3<double>;
using Matrix3 = dgd::Matrix3<double>;
using Pose = dgd::Pose<double>;

}  // namespace dgd_bullet
