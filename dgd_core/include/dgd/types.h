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

/// A vector of the space that the sets live in: L is 3 or 2.
template <class Scalar, int L>
using Vector = Eigen::Matrix<Scalar, L, 1>;

template <class Scalar, int L>
using SquareMatrix = Eigen::Matrix<Scalar, L, L>;

template <class Scalar>
using Vector2 = Vector<Scalar, 2>;

template <class Scalar>
using Vector3 = Vector<Scalar, 3>;

template <class Scalar>
using Matrix3 = SquareMatrix<Scalar, 3>;

/// Rigid pose of a set: x_world = rotation * x_local + translation.
template <class Scalar, int L = 3>
struct Pose {
  SquareMatrix<Scalar, L> rotation = SquareMatrix<Scalar, L>::Identity();  ///< Orthonormal, determinant +1.
  Vector<Scalar, L> translation = Vector<Scalar, L>::Zero();               ///< Metres, finite.

  Vector<Scalar, L> operator*(const Vector<Scalar, L>& local) const { return rotation * local + translation; }
};

/// Names a feature of a core that gives support points: a vertex, or a smooth piece of its boundary (the rim of a
/// cylinder's cap, a whole ellipsoid). A later iteration, or query, finds it again without a search.
using FeatureId = std::uint32_t;

/// A feature that is a vertex.
using VertexId = FeatureId;

/// The feature of a core that does not distinguish any.
inline constexpr FeatureId kNoFeature = std::numeric_limits<FeatureId>::max();

/// Value of a support function: a point of the set that is farthest along the direction, in the set's own frame.
template <class Scalar, int L = 3>
struct SupportPoint {
  Vector<Scalar, L> point;
  FeatureId feature = kNoFeature;
};

/// An edge from a vertex to one next to it.
template <class Scalar>
struct EdgeSlope {
  VertexId vertex;  ///< Vertex that it leads to.
  Scalar slope;  ///< Its rise by its way outwards, as their directions are long; minus infinity if none leads outwards.
};

/// A flat disc on a core's boundary: the cap of a cylinder, the base of a cone. In the core's frame.
template <class Scalar>
struct FlatDisc {
  Vector3<Scalar> normal = Vector3<Scalar>::Zero();  ///< Outwards, unit length; zero if there is no disc.
  Vector3<Scalar> center = Vector3<Scalar>::Zero();  ///< Metres.
  Scalar radius = 0;                                 ///< Metres.
};

/// A support point and how it moves with the direction d: the gradient and the Hessian of a support function.
template <class Scalar, int L = 3>
struct CurvedPoint {
  Vector<Scalar, L> point;
  /// d(point) / d(direction), metres per unit of the direction: symmetric, positive semidefinite, 0 along d. Not finite
  /// where there is no derivative.
  SquareMatrix<Scalar, L> derivative;
};

}  // namespace dgd
