#include "motion/arm.h"

#include <Eigen/Geometry>

namespace dgd_demos {
void ComputeLinkPoses(const Arm& arm, const Configuration& configuration, std::vector<Pose>& poses) {
  poses.resize(arm.links.size());
  poses[0] = arm.base;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const double angle = configuration[static_cast<Eigen::Index>(i)];
    poses[i + 1] = poses[i] * joint.origin;
    poses[i + 1].rotation *= Eigen::AngleAxisd(angle, joint.axis).toRotationMatrix();
  }
}

std::vector<Pose> LinkPoses(const Arm& arm, const Configuration& configuration) {
  std::vector<Pose> poses;
  ComputeLinkPoses(arm, configuration, poses);
  return poses;
}

Pose FlangePose(const Arm& arm, const Configuration& configuration) {
  return LinkPoses(arm, configuration).back() * arm.flange;
}

std::optional<std::size_t> FindJointBeyondLimits(const Arm& arm, const Configuration& configuration, double tolerance) {
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const double angle = configuration[static_cast<Eigen::Index>(i)];
    // False for NaN.
    const bool is_within = angle >= arm.joints[i].lower - tolerance && angle <= arm.joints[i].upper + tolerance;
    if (!is_within) return i;
  }
  return std::nullopt;
}

}  // namespace dgd_demos
