// Rebounds and rest under other settings and solvers than Bullet's defaults.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureReboundSettings(const Conditions& conditions);
Samples MeasureRestSettings(const Conditions& conditions);

}  // namespace dgd_physics
