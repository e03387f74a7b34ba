// The least translation of two shapes: for an app's own query, whose depth is to be exact, and for bodies so deep in
// each other that the growth distance's direction means little. Free of Bullet, like posed_shape.h.
#pragma once

#include "dgd/query_types.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {

/// Whether shapes are so deep in each other that a step takes the least translation: the growth distance, of which the
/// upper bound counts, shrinks with the depth, and its direction then depends on the centres more than on the surfaces.
bool IsDeep(const Contact& contact);

/// Turns the normal of a solved pair to where the shapes overlap least, or are farthest apart, with the separation and
/// the witness points: over each other along that normal, as those of a growth distance are not.
/// @param contact  In and out: the result of dgd::GrowthDistance() with these settings and this warm start; or
///                 kInvalidInput and a direction to begin with: it gets a status, and bounds over the shapes' size.
void TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            const dgd::WarmStart<double>& warm_start, Contact& contact);

}  // namespace dgd_bullet
