// Lengths that are parts of a manifold's breaking threshold, which is 2 cm for large bodies and less for small ones:
// Bullet's own measure of how far contacts may be off.
#pragma once

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What does not count when bodies pass or touch each other: 20 micrometres for large ones. With a tenth of it hulls
/// lie stiller on the ground at 60 Hz, and scaled hulls less still (physics_truth, rest: 0.003 and 0.12 in place of
/// 0.011 and 0.048); boxes and balls pass flush seams as well (box_seams).
constexpr double kNegligiblePart = 1e-3;
constexpr double NegligibleDistance(double breaking_threshold) { return kNegligiblePart * breaking_threshold; }

/// Differences of depth that do not matter to a simulation; and to nobody: picometres.
constexpr double kEqualDepthPart = 1e-3, kNoDepthPart = 1e-10;

/// Displacement that counts as none for recycled contacts. Five times as much saves another tenth of a heap's
/// narrowphase time, and triples the speed that a pyramid is left with (0.012 to 0.038 mm/s).
constexpr double kStillPart = 1e-3;

/// How far recycled contacts may drift along their reference face, and how much a distance may change on the way. In
/// float, with an eighth of the drift a heap's narrowphase takes 10 % more, and it comes to rest 1.7 s later, since
/// each contact that is found from scratch has changed a little (big_scenes --scenes boxes); without the limit on the
/// rise, depths are off by up to 58 micrometres in place of 0.4 (dispatcher_replay).
constexpr double kDriftPart = 8e-2, kRisePart = 5e-4;

/// Largest slip that a friction anchor corrects: a body that slips by more has slid. With this, scenes/pyramid_28.json
/// creeps by 1.3 mm in a minute, with a tenth of it by 25 mm (headless_sim sweep, float, contacts not recycled).
constexpr double kSlipPart = 0.01;

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
