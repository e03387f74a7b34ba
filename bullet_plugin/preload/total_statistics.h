// The sum of several narrowphases' counters.
#pragma once

#include "dgd_bullet/statistics.h"

namespace dgd_preload {

/// Adds the counters of one narrowphase to a total, types by types; the total's pairs are sorted by their types.
void Add(const dgd_bullet::Statistics& statistics, dgd_bullet::Statistics& total);

}  // namespace dgd_preload
