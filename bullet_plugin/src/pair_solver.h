// One query on a pair of adapted shapes: the growth distance, and the contact patch where they touch.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "pair_motion.h"
#include "shape_adapter.h"

namespace dgd_bullet {

/// Relative gap that the rounding of the shapes' own support functions allows: nothing to speak of, but for shapes that
/// are asked through Bullet's virtual function, which computes in Bullet's precision.
double ReachableTolerance(const PosedShape& shape_a, const PosedShape& shape_b);

/// The one place where the two types of a pair are resolved.
dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start);

/// The contact patch of a solved pair: the points that are not farther apart than `contact_distance`, and those that
/// `motion` makes touch. `spacing` as in dgd::FindContactPatch(). Metres.
dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, double contact_distance, double spacing,
                                    const PairMotion& motion);

}  // namespace dgd_bullet
