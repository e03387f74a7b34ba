// The contact patch of a solved pair.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "pair_motion.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// The points that are not farther apart than `contact_distance`, and those that `motion` makes touch. `spacing` as in
/// dgd::FindContactPatch(). Metres.
dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, double contact_distance, double spacing,
                                    const PairMotion& motion);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result);

}  // namespace dgd_bullet
