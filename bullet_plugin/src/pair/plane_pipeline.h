// What a convex shape on a static plane goes through in a step.
#pragma once

#include <memory>

#include "dgd_bullet/linkage.h"
#include "pair/pair_state.h"
#include "pair_outcome.h"
#include "shapes/hull_cache.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Finds the contacts of a convex body, which is the call's first one, on a plane, and makes the manifold's points
/// theirs.
/// @param hull  The shape's hull from one call to the next, if it is a hull of points.
PairOutcome RunPlanePipeline(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
