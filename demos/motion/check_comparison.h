// The same boolean checks by several libraries: how long they take, and where they differ.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/clearance.h"
#include "motion/collision_model.h"

namespace dgd_demos {

/// Bodies nearer to touching than this may be reported either way: |signed distance| in m.
inline constexpr double kTouchingBand = 1e-5;

struct CheckTimes {
  std::string name;
  double seconds = 0;            ///< Without the kinematics.
  std::int64_t pairs = 0;        ///< Checked.
  std::int64_t differing = 0;    ///< From dgd::DetectCollision alone, of these.
  std::int64_t beyond_band = 0;  ///< Of the differing, those that are farther from touching than the band.
};

/// All of them check the same pairs of the same states in the same order, some hundred states at a time in turns: of a
/// valid state all pairs, of another one those up to the first that collides. The core comes first, in the order of
/// StateChecker::Shortcuts.
/// @param states  As planning visited them.
std::vector<CheckTimes> CompareChecks(const CollisionModel& model, const std::vector<Configuration>& states,
                                      const Progress& progress = {});

}  // namespace dgd_demos
