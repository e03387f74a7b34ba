// Gradients of the growth distance and of the signed distance with respect to the poses of the two sets.
//
// The growth distance is the value of a saddle point problem whose saddle points are the optimal normals n and contact
// points z. Where there is one of each, the derivative of the value is that of its Lagrangian with n and z held
// constant (envelope theorem): no derivative of the solution, no second solve, and no finite difference is needed. With
// C_i the sets, c_i their centres, x_i the witness points and h_i the support functions about the centres,
//
//   s = <n, c_2 - c_1> / H,   H = h_1(n) + h_2(-n),   z = c_i + s (x_i - c_i),
//
// and the derivative with respect to the pose of set 2 is a wrench: the force n / H that acts at z (paper, Def. 3 for
// s, eq. ray-intersection-upper-bound for the normals). On set 1 acts the opposite force at the same point, so that
// moving both sets together changes nothing. Of the signed distance the force is n itself, and acts at the witness
// points.
//
// Twists. A pose moves with the linear velocity v of its frame's origin (Pose::translation) and the angular velocity w
// about that origin, both in world coordinates: d/dt translation = v, d/dt rotation = [w]x rotation. In the plane, w is
// one number, counterclockwise. The rate of the distance is then <linear, v> + <angular, w>, summed over the two sets.
//
// Where the optimum is not unique, there is no derivative. The distance's rate along a motion is the maximum over the
// optimal normals of the minimum over the contact points of the rate above (Golshtein's theorem on saddle values), so
// the gradient of any one of each belongs to Clarke's generalized gradient. For translations alone the growth distance
// is convex, and the gradient is a subgradient in the strict sense. Two flags say which of the two is not unique:
//  * the normal, if the ray between the centres leaves the Minkowski difference through an edge or a vertex of it, as
//    it does where a vertex meets a vertex;
//  * the contact point, if flat parts of both sets lie on each other: a face on a face, an edge along a face, parallel
//    edges. The derivative with respect to translations exists all the same.
//
// Derivatives of the witness points, of the contact point and of the normal are not given. They exist only where no
// feature changes and the contact is not flat: of a vertex on a face, the normal turns with the face and its derivative
// is elementary, while of curved sets they need the curvature of both surfaces, which a support function does not have
// to provide (SmoothCore in convex_set.h is optional). At an edge of the Minkowski difference they jump. Who needs a
// second derivative of the distance takes differences of the gradients here, whose error is that of the solution and
// does not grow with the inverse square of the step.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "dgd/contact/facing_boundaries.h"
#include "dgd/convex_set.h"
#include "dgd/query_types.h"
#include "dgd/signed_distance.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// An angular velocity: a vector in space, and one number in the plane.
template <class S, int L>
using AngularVector = Vector<S, L == 3 ? 3 : 1>;

/// Derivative of a distance with respect to one pose. For the growth distance per metre and per radian, for the signed
/// distance dimensionless and metres per radian. World coordinates.
template <class S, int L = 3>
struct PoseGradient {
  Vector<S, L> linear = Vector<S, L>::Zero();                 ///< Derivative by the velocity of the frame's origin.
  AngularVector<S, L> angular = AngularVector<S, L>::Zero();  ///< Derivative by the angular velocity about that origin.

  /// The distance's rate of change while the pose moves with this twist.
  S Rate(const Vector<S, L>& velocity, const AngularVector<S, L>& angular_velocity) const {
    return linear.dot(velocity) + angular.dot(angular_velocity);
  }
};

/// Derivatives of a distance with respect to both poses, and whether they are derivatives. Every field is set whatever
/// the status.
template <class S, int L = 3>
struct Gradient {
  /// Status of the result it was made from. kOptimal, kIterationLimit, kStalled, kCoincidentCenters: the gradient of
  /// the normal and the contact point that were found, if the result has any; the first is exact to the solution's
  /// error. All others (kSeparated among them, which stops before there is an optimum): zero. kInvalidInput also for
  /// NaN or infinity in a pose, a radius, a core or the result, and for a normal whose length is not 1. kNoInterior
  /// also if the sets have no extent along the normal.
  Status status = Status::kInvalidInput;
  PoseGradient<S, L> pose_1, pose_2;
  /// Whether no other normal and no other contact point is optimal. True is certain within the tolerances of
  /// gradient_internal; false says that another may be, or that the result is too inexact to decide.
  bool is_normal_unique = false;
  bool is_contact_unique = false;

  /// Whether the gradient is the derivative; if not, it is an element of the generalized gradient.
  bool IsUnique() const { return is_normal_unique && is_contact_unique; }
};

namespace gradient_internal {

template <class S>
AngularVector<S, 3> Cross(const Vector<S, 3>& arm, const Vector<S, 3>& force) {
  return arm.cross(force);
}
template <class S>
AngularVector<S, 2> Cross(const Vector<S, 2>& arm, const Vector<S, 2>& force) {
  return AngularVector<S, 2>(arm.x() * force.y() - arm.y() * force.x());
}

/// Whether poses and a result are finite, and the normal has unit length: support functions take no other.
template <class S, int L>
bool IsUsable(const Pose<S, L>& pose_1, const Pose<S, L>& pose_2, const Vector<S, L>& normal,
              const Vector<S, L>& witness_1, const Vector<S, L>& witness_2) {
  const S sum = pose_1.rotation.sum() + pose_1.translation.sum() + pose_2.rotation.sum() + pose_2.translation.sum() +
                witness_1.sum() + witness_2.sum();
  return std::isfinite(sum) && std::abs(normal.squaredNorm() - 1) <= kSqrtEpsilon<S>;  // False for NaN.
}

template <class S, int L>
bool IsFinite(const Gradient<S, L>& gradient) {
  return std::isfinite(gradient.pose_1.linear.sum() + gradient.pose_1.angular.sum() + gradient.pose_2.linear.sum() +
                       gradient.pose_2.angular.sum());
}

/// Whether a query with this status found a normal and a contact point, exact or not.
inline bool HasOptimum(Status status) {
  return status == Status::kOptimal || status == Status::kIterationLimit || status == Status::kStalled ||
         status == Status::kCoincidentCenters;
}

/// The gradient that is a force on set 2 and its opposite on set 1. Both act at the middle of two points that should be
/// one, or on one line along the force: so moving both sets together changes nothing, however inexact the points are.
/// @param arm_1, arm_2  The points, each from its pose's origin.
template <class S, int L>
void SetForce(const Vector<S, L>& force, const Pose<S, L>& pose_1, const Vector<S, L>& arm_1, const Pose<S, L>& pose_2,
              const Vector<S, L>& arm_2, Gradient<S, L>& gradient) {
  const Vector<S, L> between = pose_2.translation - pose_1.translation;
  const Vector<S, L> half_miss = (between + arm_2 - arm_1) / 2;
  gradient.pose_1.linear = -force;
  gradient.pose_1.angular = -Cross<S>(Vector<S, L>(arm_1 + half_miss), force);
  gradient.pose_2.linear = force;
  gradient.pose_2.angular = Cross<S>(Vector<S, L>(arm_2 - half_miss), force);
}

}  // namespace gradient_internal

/// Gradient of the growth distance with respect to the two poses.
/// @param result  Of GrowthDistance() for these sets and poses. The gradient is as exact as its normal and witness
///                points: polytopes' are exact whatever the tolerance was; those of curved sets are off by about the
///                relative gap where second-order steps found them (SmoothCore), by its square root times the sets'
///                curvature otherwise. With relative_tolerance = 1e-15 the result may be kStalled, which is as good as
///                the scalar allows; a second query from its warm start begins with second-order steps.
/// Costs two evaluations of each support function, and 8 to 40 for the two flags. Allocates nothing and does not throw.
/// Source: the paper's Def. 3 and its dual, differentiated at the optimum; derivation at the top of this file.
template <class Set1, class Set2>
requires ConvexCore<typename Set1::Core> && ConvexCore<typename Set2::Core>
    Gradient<typename Set1::Scalar, kDimension<typename Set1::Core>> GrowthDistanceGradient(
        const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
        const ResultOf<Set1>& result) {
  using namespace gradient_internal;
  using S = typename Set1::Scalar;
  constexpr int L = kDimension<typename Set1::Core>;
  using Point = Vector<S, L>;
  Gradient<S, L> gradient;
  if (!IsUsable(pose_1, pose_2, result.normal, result.witness_1, result.witness_2)) return gradient;
  gradient.status = result.status;
  const S growth_distance = result.GrowthDistance();
  if (!HasOptimum(result.status) || !std::isfinite(growth_distance)) return gradient;

  FacingBoundaries<Set1, Set2> boundaries(set_1, pose_1, set_2, pose_2, result.normal);
  const S height = boundaries.boundary_1.Height() + boundaries.boundary_2.Height();
  if (!(height > 0 && std::isfinite(height))) {
    gradient.status = height <= 0 ? Status::kNoInterior : Status::kInvalidInput;
    return gradient;
  }
  const Point &center_1 = boundaries.boundary_1.Center(), &center_2 = boundaries.boundary_2.Center();
  const Point offset_1 = result.witness_1 - pose_1.translation - center_1;
  const Point offset_2 = result.witness_2 - pose_2.translation - center_2;
  SetForce<S, L>(result.normal / height, pose_1, center_1 + growth_distance * offset_1, pose_2,
                 center_2 + growth_distance * offset_2, gradient);
  if (!gradient_internal::IsFinite(gradient)) return {};

  const S roundoff = kResolution<S> * (boundaries.Size() + offset_1.norm() + offset_2.norm() +
                                       std::max(pose_1.translation.norm(), pose_2.translation.norm()));
  const S gap = growth_distance > 0 ? (growth_distance - result.lower_bound) / growth_distance : S(0);
  gradient.is_contact_unique = boundaries.IsContactUnique();
  gradient.is_normal_unique = result.status != Status::kCoincidentCenters &&
                              boundaries.IsNormalUnique(boundaries.tangents.transpose() * (offset_1 - offset_2),
                                                        roundoff + gap * boundaries.Size());
  return gradient;
}

/// Gradient of the signed distance with respect to the two poses; in space.
/// @param result  Of SignedDistance() or UpdateDistance() for these sets and poses. The normal
///                of sets whose cores overlap is not reported as unique: another one elsewhere may be as good, and the
///                distance is then the larger one of what either says. Neither is that of a result whose bounds differ
///                by more than the root of the scalar's epsilon times the sets' size.
/// It is as GrowthDistanceGradient() in all else.
template <class Set1, class Set2>
requires ConvexCore<typename Set1::Core> && ConvexCore<typename Set2::Core> Gradient<typename Set1::Scalar>
SignedDistanceGradient(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
                       const SignedDistanceResult<typename Set1::Scalar>& result) {
  using namespace gradient_internal;
  using S = typename Set1::Scalar;
  Gradient<S> gradient;
  if (!IsUsable(pose_1, pose_2, result.normal, result.witness_1, result.witness_2)) return gradient;
  if (!std::isfinite(result.separation)) return gradient;
  gradient.status = result.status;
  if (!HasOptimum(result.status)) return gradient;

  const Vector3<S> arm_1 = result.witness_1 - pose_1.translation, arm_2 = result.witness_2 - pose_2.translation;
  SetForce<S, 3>(result.normal, pose_1, arm_1, pose_2, arm_2, gradient);
  FacingBoundaries<Set1, Set2> boundaries(set_1, pose_1, set_2, pose_2, result.normal);
  if (!std::isfinite(boundaries.boundary_1.Height() + boundaries.boundary_2.Height())) return {};
  const S roundoff = kResolution<S> * (boundaries.Size() + arm_1.norm() + arm_2.norm() +
                                       std::max(pose_1.translation.norm(), pose_2.translation.norm()));
  gradient.is_contact_unique = boundaries.IsContactUnique();
  const bool is_exact = result.upper_bound - result.separation <= roundoff + kSqrtEpsilon<S> * boundaries.Size();
  gradient.is_normal_unique = is_exact && result.separation + boundaries.radii > roundoff;
  return gradient;
}

}  // namespace dgd
