// Whether two bodies that are apart really meet within the time step.
#pragma once

#include "dgd/growth_distance.h"
#include "pair_motion.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// True if the bodies, moving on as they do, touch within the time step, and the plane between them now is about the
/// one on which they then touch. Their approach along that plane's normal alone does not say so: a body that flies past
/// an edge approaches it too, and a contact would deflect it.
///
/// By a sweep (dgd/time_of_impact.h) of a few planes: bodies that turn fast may be missed. Bodies that come nearer than
/// a hundredth of their first separation count as touching.
/// @param result, warm_start  Of the shapes in their present poses; apart.
bool TouchWithinStep(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     const dgd::WarmStart<double>& warm_start, const PairMotion& motion);

}  // namespace dgd_bullet
