// From the growth distance's normal to that of the signed distance. Free of Bullet, and compiled once, as
// pair_solver.h.
#pragma once

#include "dgd/query_types.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// Turns the normal of a solved pair to where the bodies overlap least, or are farthest apart, and the separation and
/// the witness points with it; leaves all as it is if that gains nothing.
/// @param settings, warm_start  As SolvePair() had and left them; the latter is left for FollowDistance() if that can
///                              go on from here.
/// @return whether it can.
bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, dgd::Result<double>& result);

/// In the place of SolvePair() and TurnToLeastTranslation(), at less than half their cost, for a pair that the last
/// call of either function here said it of, and for one that was apart or is new. The growth distance stays unknown.
/// @return false, with nothing changed, if the pair's cores are not apart, or it is to be solved first: polytopes that
///         are new, shapes that only Bullet can evaluate.
bool FollowDistance(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                    dgd::WarmStart<double>& warm_start, dgd::Result<double>& result);

}  // namespace dgd_bullet
