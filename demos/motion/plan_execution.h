// Has a planned motion carried out by Bullet, and judges how it went.
#pragma once

#include "motion/clearance.h"
#include "motion/motion_scene.h"
#include "motion/plan_run.h"

namespace dgd_demos {

/// Carries out the smoothed path of a run that has one (simulation/execution.h): timed within the joints' velocity
/// limits, its corners cut by no more than what leaves half of the clearance to points at most a metre from the axes.
/// Sets PlanRun::execution, unless the path takes more than ten minutes, and PlanRun::execution_failure where the arm
/// does not follow the path: where the flange is off it by more than a centimetre, a body is touched, or a joint is
/// beyond its limits.
void ExecutePlan(const MotionScene& scene, PlanRun& run, const Progress& progress);

}  // namespace dgd_demos
