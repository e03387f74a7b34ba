#include "motion/collision_model.h"

#include "motion/checked_pairs.h"

namespace dgd_demos {
namespace {

/// Each pair of links once, the outer one first.
bool IsChecked(const SceneArm& arm, const CollisionModel::Part& first, const CollisionModel::Part& second) {
  if (!first.link) return false;
  if (!second.link) return IsCheckedAgainst(arm, *first.link, second.body.name());
  return *first.link > *second.link && AreLinksChecked(arm, *first.link, *second.link);
}

}  // namespace

CollisionModel::CollisionModel(const MotionScene& scene) : arm_(scene.PlannedArm()) {
  for (std::size_t link = 0; link < arm_.links.size(); ++link) {
    for (const LinkShape& shape : arm_.links[link].shapes) {
      parts_.push_back({ConvexBody(arm_.links[link].name, shape.shape), link, shape.pose});
    }
  }
  for (const FixedBody& fixed : FixedBodiesOf(scene)) {
    for (const LinkShape& shape : fixed.shapes) {
      parts_.push_back({ConvexBody(fixed.name, shape.shape), std::nullopt, fixed.pose * shape.pose});
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
      poses[i] = ToDgd(link_poses[*part.link] * part.pose);
    } else if (is_first_call) {
      poses[i] = ToDgd(part.pose);
    } else {
      break;  // All others are fixed, too.
    }
  }
}

}  // namespace dgd_demos
