// Bodies that come to rest and stay there, and thin plates that hold.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureDropDead(const Conditions& conditions);
Samples MeasureRest(const Conditions& conditions);
Samples MeasurePoles(const Conditions& conditions);
Samples MeasureWeight(const Conditions& conditions);
Samples MeasureSoftContacts(const Conditions& conditions);
Samples MeasureStack(const Conditions& conditions);
Samples MeasureTunnel(const Conditions& conditions);

}  // namespace dgd_physics
