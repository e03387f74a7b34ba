// Bodies that pass each other without touching: nothing happens to them.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureNearRod(const Conditions& conditions);
Samples MeasureGraze(const Conditions& conditions);
Samples MeasureTumble(const Conditions& conditions);
Samples MeasurePastEdge(const Conditions& conditions);
Samples MeasureOverRidge(const Conditions& conditions);

}  // namespace dgd_physics
