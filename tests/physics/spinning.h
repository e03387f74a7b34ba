// Discs, balls and wheels that roll and spin without loss.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureEulerDisc(const Conditions& conditions);
Samples MeasureDiscCircle(const Conditions& conditions);
Samples MeasureRolling(const Conditions& conditions);

}  // namespace dgd_physics
