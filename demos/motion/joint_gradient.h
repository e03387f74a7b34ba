// From the wrench that a distance's gradient is to the derivatives by the joints, through each link's Jacobian.
#pragma once

#include <dgd/gradient.h>

#include <Eigen/Core>
#include <vector>

#include "motion/collision_model.h"
#include "scene/pose.h"

namespace dgd_demos {

/// Derivative of a pair's distance with respect to the arm's joint angles: per radian, times the distance's unit.
///
/// A joint turns all links beyond it about its axis. With a the axis and p a point on it, a part's frame at t moves by
/// the linear velocity a x (t - p) and the angular velocity a: a column of the geometric Jacobian, whose product with
/// the wrench is the derivative.
/// @param link_poses  Of LinkPoses() for the state.
/// @param poses       Of CollisionModel::ComputePoses() for the state.
/// @param gradient    Of GrowthDistanceGradient() or SignedDistanceGradient() for the pair in these poses.
Configuration JointGradient(const CollisionModel& model, const std::vector<Pose>& link_poses,
                            const CollisionModel::Poses& poses, const CheckedPair& pair,
                            const dgd::Gradient<double>& gradient);

}  // namespace dgd_demos
