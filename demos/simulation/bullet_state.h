// What there is to know of Bullet's objects after a step, in the demos' types.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <vector>

#include "simulation/collision_input.h"
#include "simulation/step_record.h"
#include "simulation/timing_dispatcher.h"

namespace dgd_demos {

/// Of the step just taken. @param fallbacks  in this step.
CollisionReport ReportStep(TimingDispatcher& dispatcher, const btOverlappingPairCache& pairs, std::uint64_t fallbacks);

/// By the objects' user indices.
std::vector<BodyPair> IndexPairs(const btOverlappingPairCache& pairs);

double KineticEnergy(const btRigidBody& body);  ///< J

}  // namespace dgd_demos
