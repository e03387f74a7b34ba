#include "motion/checked_pairs.h"

#include <algorithm>

namespace dgd_demos {
namespace {

bool IsUnchecked(const SceneArm& arm, const std::string& a, const std::string& b) {
  return std::ranges::any_of(arm.unchecked, [&](const auto& names) {
    return (names.first == a && names.second == b) || (names.first == b && names.second == a);
  });
}

}  // namespace

std::vector<FixedBody> FixedBodiesOf(const MotionScene& scene) {
  std::vector<FixedBody> bodies;
  for (const Obstacle& obstacle : scene.obstacles) {
    bodies.push_back({obstacle.name, {{obstacle.shape, Pose()}}, obstacle.pose});
  }
  for (std::size_t i = 0; i < scene.arms.size(); ++i) {
    if (i == scene.planned_arm) continue;
    const Arm& arm = scene.arms[i].arm;
    const std::vector<Pose> poses = LinkPoses(arm, scene.arms[i].rest);
    for (std::size_t link = 0; link < arm.links.size(); ++link) {
      bodies.push_back({arm.name + "'s " + arm.links[link].name, arm.links[link].shapes, poses[link]});
    }
  }
  return bodies;
}

bool AreLinksChecked(const SceneArm& arm, std::size_t link, std::size_t other) {
  const auto [inner, outer] = std::minmax(link, other);
  return outer - inner > 1 && !IsUnchecked(arm, arm.arm.links[link].name, arm.arm.links[other].name);
}

bool IsCheckedAgainst(const SceneArm& arm, std::size_t link, const std::string& fixed_body) {
  return link > 0 && !IsUnchecked(arm, arm.arm.links[link].name, fixed_body);
}

}  // namespace dgd_demos
