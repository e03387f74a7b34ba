// Rebounds with friction and restitution at once.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureSpinRebound(const Conditions& conditions);
Samples MeasureAngularMomentum(const Conditions& conditions);

}  // namespace dgd_physics
