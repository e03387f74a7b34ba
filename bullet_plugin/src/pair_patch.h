// The contact patch of a solved pair.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/facing_faces.h"
#include "dgd/query_types.h"
#include "pair_motion.h"
#include "posed_shape.h"

namespace dgd_bullet {

/// What the shapes show each other along the result's normal.
void FindFacingFaces(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     double angular_tolerance, dgd::FacingFaces<double>& facing);

/// The points that belong to the patch by `settings`, and those that `motion` makes touch.
dgd::ContactPatch<double> FindPatch(const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result);

}  // namespace dgd_bullet
