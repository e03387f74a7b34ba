// One query on a pair of adapted shapes: the growth distance, and the contact patch where they touch.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "shape_adapter.h"

namespace dgd_bullet {

/// The one place where the two types of a pair are resolved.
dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start);

/// @param contact_distance, spacing  As in dgd::FindContactPatch(), metres.
dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, double contact_distance, double spacing);

}  // namespace dgd_bullet
