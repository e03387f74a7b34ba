// When two adapted shapes that move first touch. Free of Bullet, and compiled once, as pair_solver.h.
#pragma once

#include "dgd/time_of_impact.h"
#include "posed_shape.h"

namespace dgd_bullet {

using Motion = dgd::Motion<double>;

/// The shapes' poses are where the motions start.
dgd::TimeOfImpactResult<double> SweepPair(const PosedShape& shape_a, const Motion& motion_a, const PosedShape& shape_b,
                                          const Motion& motion_b, const dgd::SweepSettings<double>& settings);

}  // namespace dgd_bullet
