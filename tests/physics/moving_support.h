// Dry friction on supports that move, or only say that they do.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureBelt(const Conditions& conditions);
Samples MeasurePlatform(const Conditions& conditions);
Samples MeasureFeeder(const Conditions& conditions);
Samples MeasureTeleport(const Conditions& conditions);

}  // namespace dgd_physics
