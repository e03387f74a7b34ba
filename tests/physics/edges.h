// Inner edges that bodies slide over, and outer edges that they stand, turn and fall on.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureBoxSeams(const Conditions& conditions);
Samples MeasureMeshSeams(const Conditions& conditions);
Samples MeasureLargeBoxes(const Conditions& conditions);
Samples MeasureLines(const Conditions& conditions);
Samples MeasureTip(const Conditions& conditions);
Samples MeasureRocking(const Conditions& conditions);

}  // namespace dgd_physics
