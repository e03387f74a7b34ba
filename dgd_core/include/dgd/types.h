// Vectors, poses and the support point: the words that every header of dgd_core shares.
//
// Lengths are metres, angles radians. Scalar is double or float. The types have no alignment beyond their scalar's, so
// that they may live anywhere, also in Bullet's 8-byte aligned pools.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>

namespace dgd {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;

/// Rigid pose of a set: x_world = rotation * x_local + translation.
template <class Scalar>
struct Pose {
  Matrix3<Scalar> rotation = Matrix3<Scalar>::Identity();  ///< Orthonormal, determinant +1.
  Vector3<Scalar> translation = Vector3<Scalar>::Zero();   ///< Metres, finite.

  Vector3<Scalar> operator*(const Vector3<Scalar>& local) const { return rotation * local + translation; }
};

/// Names a vertex of a core, so that a later query can find the same point again; see WarmStart.
using VertexId = std::uint32_t;

/// The point is not a vertex (curved core, or a point that no vertex gave).
inline constexpr VertexId kNoVertex = std::numeric_limits<VertexId>::max();

/// Value of a support function: a point of the set that is farthest along the direction, in the set's own frame.
template <class Scalar>
struct SupportPoint {
  Vector3<Scalar> point;
  VertexId vertex = kNoVertex;
};

}  // namespace dgd
