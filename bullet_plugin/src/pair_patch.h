// The contact patch of a solved pair.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "pair_motion.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// The points that belong to it by `settings`, and those that `motion` makes touch.
dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, const dgd::PatchSettings<double>& settings,
                                    const PairMotion& motion);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result);

}  // namespace dgd_bullet
