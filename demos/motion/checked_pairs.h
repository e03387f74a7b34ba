// Which bodies of a motion scene are checked against each other: by planning, and by the simulation of what it planned.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/arm.h"
#include "motion/motion_scene.h"
#include "scene/pose.h"

namespace dgd_demos {

/// A body that stays where it is while the planned arm moves.
struct FixedBody {
  std::string name;               ///< A link of another arm is "NAME's LINK".
  std::vector<LinkShape> shapes;  ///< In the body's frame.
  Pose pose;                      ///< In the world.
};

/// The obstacles, then the links of all arms but the planned one, at rest.
std::vector<FixedBody> FixedBodiesOf(const MotionScene& scene);

/// Whether two links of an arm are checked: neighbours, which touch where they are joined, and unchecked pairs are not.
/// @param link, other  Indices in Arm::links, in any order.
bool AreLinksChecked(const SceneArm& arm, std::size_t link, std::size_t other);

/// Whether a link of an arm is checked against a fixed body. The base is not: it does not move either.
/// @param link  Index in Arm::links.
bool IsCheckedAgainst(const SceneArm& arm, std::size_t link, const std::string& fixed_body);

}  // namespace dgd_demos
