// The growth distance of a pair of adapted shapes. Free of Bullet, like posed_shape.h: compiled once, since every pair
// of types is a solver of its own.
#pragma once

#include "dgd/growth_distance.h"
#include "posed_shape.h"

namespace dgd_bullet {

dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start);

}  // namespace dgd_bullet
