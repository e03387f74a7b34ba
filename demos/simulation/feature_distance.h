// Distances between the features of polyhedra: the two closed forms from which the oracle builds everything else.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace dgd_demos {

/// A shortest connection between two features.
struct Connection {
  double distance;                      ///< m
  Eigen::Vector3d on_first, on_second;  ///< Its ends.
};

using Segment = std::array<Eigen::Vector3d, 2>;
using Triangle = std::array<Eigen::Vector3d, 3>;

/// Shortest connection of two segments. Either may have no length, and they may be parallel.
Connection Connect(const Segment& first, const Segment& second);

/// Connection of a point with the inside of a triangle, from the side to which `normal` points; none if the point is
/// on the other side or its projection falls outside of the triangle. The triangle's edges are the other function's.
/// @param normal  of the triangle, unit length.
std::optional<Connection> ConnectToInside(const Eigen::Vector3d& point, const Triangle& triangle,
                                          const Eigen::Vector3d& normal);

}  // namespace dgd_demos
