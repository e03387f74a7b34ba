// Dry friction on ground that does not move: Coulomb's law.
#pragma once

#include "physics/experiment.h"

namespace dgd_physics {

Samples MeasureSlide(const Conditions& conditions);
Samples MeasureSwingForce(const Conditions& conditions);
Samples MeasureTaps(const Conditions& conditions);
Samples MeasureIncline(const Conditions& conditions);
Samples MeasureTiles(const Conditions& conditions);
Samples MeasureTorsion(const Conditions& conditions);

}  // namespace dgd_physics
