#include "motion/joint_gradient.h"

#include <Eigen/Geometry>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// Adds the part's share: the joints from the base to its link move it, and no other.
void AddPart(const CollisionModel& model, const std::vector<Pose>& link_poses, std::size_t part,
             const dgd::Pose<double>& pose, const dgd::PoseGradient<double>& wrench, Configuration& derivative) {
  const std::size_t link = model.parts()[part].link.value_or(0);
  for (std::size_t joint = 0; joint < link; ++joint) {
    const Pose& child = link_poses[joint + 1];
    const Vector3d axis = child.rotation * model.arm().joints[joint].axis;
    const Vector3d velocity = axis.cross(pose.translation - child.position);
    derivative[static_cast<Eigen::Index>(joint)] += wrench.Rate(velocity, axis);
  }
}

}  // namespace

Configuration JointGradient(const CollisionModel& model, const std::vector<Pose>& link_poses,
                            const CollisionModel::Poses& poses, const CheckedPair& pair,
                            const dgd::Gradient<double>& gradient) {
  Configuration derivative = Configuration::Zero(static_cast<Eigen::Index>(model.arm().joints.size()));
  AddPart(model, link_poses, pair.first, poses[pair.first], gradient.pose_1, derivative);
  AddPart(model, link_poses, pair.second, poses[pair.second], gradient.pose_2, derivative);
  return derivative;
}

}  // namespace dgd_demos
