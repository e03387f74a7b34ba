// State of Bullet's objects after a step, in the demos' types.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <vector>

#include "simulation/collision_input.h"
#include "simulation/step_record.h"
#include "simulation/timing_dispatcher.h"

namespace dgd_demos {

/// Counts of the last step. @param fallbacks  Fallbacks in this step.
CollisionReport ReportStep(TimingDispatcher& dispatcher, const btOverlappingPairCache& pairs, std::uint64_t fallbacks);

/// Overlapping pairs, by the objects' user indices.
std::vector<BodyPair> IndexPairs(const btOverlappingPairCache& pairs);

double KineticEnergy(const btRigidBody& body);  ///< J

}  // namespace dgd_demos
