// Wheels, barrels and balls given as hulls, and dice: what rolls over corners.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureRollingHulls(const Conditions& conditions);

}  // namespace dgd_physics
