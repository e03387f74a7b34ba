#include "motion/arm.h"

#include <Eigen/Geometry>

namespace dgd_demos {
namespace {

Pose Compose(const Pose& parent, const Pose& child) {
  return {parent.rotation * child.rotation, parent * child.position};
}

}  // namespace

void ComputeLinkPoses(const Arm& arm, const Configuration& configuration, std::vector<Pose>& poses) {
  poses.resize(arm.links.size());
  poses[0] = arm.base;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const double angle = configuration[static_cast<Eigen::Index>(i)];
    poses[i + 1] = Compose(poses[i], joint.origin);
    poses[i + 1].rotation *= Eigen::AngleAxisd(angle, joint.axis).toRotationMatrix();
  }
}

std::vector<Pose> LinkPoses(const Arm& arm, const Configuration& configuration) {
  std::vector<Pose> poses;
  ComputeLinkPoses(arm, configuration, poses);
  return poses;
}

Pose FlangePose(const Arm& arm, const Configuration& configuration) {
  return Compose(LinkPoses(arm, configuration).back(), arm.flange);
}

std::optional<std::size_t> FindJointBeyondLimits(const Arm& arm, const Configuration& configuration) {
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const double angle = configuration[static_cast<Eigen::Index>(i)];
    const bool is_within = angle >= arm.joints[i].lower && angle <= arm.joints[i].upper;  // False for NaN.
    if (!is_within) return i;
  }
  return std::nullopt;
}

}  // namespace dgd_demos
