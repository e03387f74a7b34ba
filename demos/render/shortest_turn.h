// From one direction to another.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace dgd_demos {

/// The turn by the least angle that takes a unit vector to another, not opposite one. In the place of Eigen's
/// FromTwoVectors(), whose singular value decomposition takes the compiler longer than a whole file here.
inline Eigen::AngleAxisd ShortestTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d axis = from.cross(to);
  return Eigen::AngleAxisd(std::atan2(axis.norm(), from.dot(to)), axis.normalized());
}

}  // namespace dgd_demos
