// Whether two bodies that are apart really meet within the time step, and where.
#pragma once

#include <optional>

#include "dgd/growth_distance.h"
#include "pair_motion.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// Where two bodies meet within the step, as they are at its start.
struct PredictedImpact {
  bool is_along_normal;         ///< Whether they meet on about the plane that is between them now.
  dgd::Result<double> contact;  ///< Else: the normal at the impact, and the two points that will touch.
};

/// Sweeps the shapes along the bodies' motion. That they approach along the normal between them does not say that they
/// meet: a body that flies past an edge approaches it too, and a contact would deflect it.
///
/// By a few planes: bodies that turn very fast may be missed.
/// @param flush       Metres: bodies that never overlap by more than this do not meet, so that one that slides over the
///                    seam of two others, flush but for roundoff, is not stopped by the second one's side.
/// @param result, warm_start  Of the shapes in their present poses; apart, or overlapping by less than `flush`.
std::optional<PredictedImpact> PredictImpact(const PosedShape& shape_a, const PosedShape& shape_b,
                                             const dgd::Result<double>& result,
                                             const dgd::WarmStart<double>& warm_start, const PairMotion& motion,
                                             double flush);

}  // namespace dgd_bullet
