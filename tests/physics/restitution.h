// Rebounds: Newton's law of restitution, and what follows from it for energies, heights and rows of balls.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureHeadOn(const Conditions& conditions);
Samples MeasureGas(const Conditions& conditions);
Samples MeasureBounce(const Conditions& conditions);
Samples MeasureObliqueBounce(const Conditions& conditions);
Samples MeasureCradle(const Conditions& conditions);
Samples MeasureBat(const Conditions& conditions);

}  // namespace dgd_physics
