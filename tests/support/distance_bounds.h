// How far the origin is from a convex set that is known by its support function alone, from both sides: a plane that
// proves no less, points of the set that prove no more. Shares no code with the solvers that it judges.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace dgd_test {

/// Farthest point of the set along a direction, which need not be of unit length.
using SupportFunction = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// The signed distance: positive outside, minus the least translation to the surface inside. Metres.
struct DistanceBounds {
  double lower = 0;                 ///< Of the supporting plane along `normal`.
  double upper = 0;                 ///< Of a point of the set; inside, of a polytope in the set.
  Eigen::Vector3d normal{0, 0, 0};  ///< Unit, outward of the set: where it is outside, towards the origin.
};

/// GJK's and EPA's ideas, with every bound from points and planes as they are and none from the algorithm's state: slow
/// and sure. Where rounding or a flat set keeps the bounds apart, they are so returned.
DistanceBounds BoundDistanceToOrigin(const SupportFunction& support);

}  // namespace dgd_test
