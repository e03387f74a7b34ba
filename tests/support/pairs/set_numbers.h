// Sets, poses and pairs of them as plain numbers, of two or three dimensions: what generators make, and what a failing
// case is printed as.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "support/pairs/set_type.h"

namespace dgd_test {

/// core + ball(radius), in its own frame; metres. what the lengths and points mean, with_core.h says.
struct SetNumbers {
  SetType type = SetType::kPoint;
  Eigen::Vector3d lengths = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> points = {};
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();  ///< Of the types that are an affine image of another.
  double radius = 0;
  double exponent = 0;  ///< Of a dsf or superellipsoid.

  bool HasInterior() const { return InfoOf(type).is_solid || radius > 0; }
};

/// x_world = rotation * x_local + translation. In the plane: a turn about z, and z = 0.
struct PoseNumbers {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

struct PairNumbers {
  SetNumbers set_1, set_2;
  PoseNumbers pose_1, pose_2;
};

/// The same pair with every number rounded to float, so that float and double are asked the same question.
PairNumbers RoundedToFloat(const PairNumbers& pair);

/// All numbers with 17 digits.
std::string Dump(const PairNumbers& pair);

}  // namespace dgd_test
