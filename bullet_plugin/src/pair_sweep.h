// When two adapted shapes that move first touch. Free of Bullet, and compiled once, as pair_solver.h.
#pragma once

#include "dgd/time_of_impact.h"
#include "posed_shape.h"

namespace dgd_bullet {

using Motion = dgd::Motion<double>;

/// The shapes' poses are where the motions start.
/// @param at_start    A plane between the shapes there, if one is known.
/// @param warm_start  Where to look for others from.
dgd::TimeOfImpactResult<double> SweepPair(const PosedShape& shape_a, const Motion& motion_a, const PosedShape& shape_b,
                                          const Motion& motion_b, const dgd::SweepSettings<double>& settings,
                                          const dgd::Result<double>* at_start = nullptr,
                                          dgd::WarmStart<double> warm_start = {});

}  // namespace dgd_bullet
