#include "motion/collision_model.h"

#include <algorithm>

namespace dgd_demos {
namespace {

Pose Compose(const Pose& parent, const Pose& child) {
  return {parent.rotation * child.rotation, parent * child.position};
}

// Whether the file excludes the pair, or the two links are one, or neighbours, which touch where they are joined.
bool IsChecked(const SceneArm& scene_arm, const CollisionModel::Part& first, const CollisionModel::Part& second) {
  if (!first.link) return false;
  if (second.link) {
    if (*first.link < *second.link + 2) return false;  // Each pair once, the outer link first.
  } else if (*first.link == 0) {
    return false;  // The base does not move.
  }
  const std::string &a = first.body.name(), &b = second.body.name();
  return std::ranges::none_of(scene_arm.unchecked, [&](const auto& names) {
    return (names.first == a && names.second == b) || (names.first == b && names.second == a);
  });
}

}  // namespace

CollisionModel::CollisionModel(const MotionScene& scene) : arm_(scene.PlannedArm()) {
  for (std::size_t link = 0; link < arm_.links.size(); ++link) {
    for (const LinkShape& shape : arm_.links[link].shapes) {
      parts_.push_back({ConvexBody(arm_.links[link].name, shape.shape), link, shape.pose});
    }
  }
  for (const Obstacle& obstacle : scene.obstacles) {
    parts_.push_back({ConvexBody(obstacle.name, obstacle.shape), std::nullopt, obstacle.pose});
  }
  for (std::size_t i = 0; i < scene.arms.size(); ++i) {
    if (i == scene.planned_arm) continue;
    const Arm& other = scene.arms[i].arm;
    const std::vector<Pose> link_poses = LinkPoses(other, scene.arms[i].rest);
    for (std::size_t link = 0; link < other.links.size(); ++link) {
      const std::string name = other.name + "'s " + other.links[link].name;
      for (const LinkShape& shape : other.links[link].shapes) {
        parts_.push_back({ConvexBody(name, shape.shape), std::nullopt, Compose(link_poses[link], shape.pose)});
      }
    }
  }
  const SceneArm& planned = scene.arms[scene.planned_arm];
  for (std::size_t first = parts_.size(); first-- > 0;) {
    for (std::size_t second = 0; second < parts_.size(); ++second) {
      if (IsChecked(planned, parts_[first], parts_[second])) pairs_.push_back({first, second});
    }
  }
}

std::string CollisionModel::NameOf(const CheckedPair& pair) const {
  return parts_[pair.first].body.name() + " and " + parts_[pair.second].body.name();
}

void CollisionModel::ComputePoses(const Configuration& configuration, Poses& poses) const {
  thread_local std::vector<Pose> link_poses;  // Kept, so that a check in a planner's loop allocates nothing.
  ComputeLinkPoses(arm_, configuration, link_poses);
  const bool is_first_call = poses.size() != parts_.size();
  poses.resize(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (part.link) {
      poses[i] = ToDgd(Compose(link_poses[*part.link], part.pose));
    } else if (is_first_call) {
      poses[i] = ToDgd(part.pose);
    } else {
      break;  // All others are fixed, too.
    }
  }
}

}  // namespace dgd_demos
