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
//  it
//    does where a vertex meets a vertex;
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
#include <array>
#include <cmath>
#include <limits>

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
  Vector<S, L> linear = Vector<S, L>::Zero();                 ///< By the velocity of the frame's origin.
  AngularVector<S, L> angular = AngularVector<S, L>::Zero();  ///< By the angular velocity about that origin.

  /// The distance's rate of change while the pose moves with this twist.
  S Rate(const Vector<S, L>& velocity, const AngularVector<S, L>& angular_velocity) const {
    return linear.dot(velocity) + angular.dot(angular_velocity);
  }
};

/// Derivatives of a distance with respect to both poses, and whether they are derivatives. Every field is set whatever
/// the status.
template <class S, int L = 3>
struct Gradient {
  /// That of the result it was made from. kOptimal, kIterationLimit, kStalled, kCoincidentCenters: the gradient of the
  /// normal and the contact point that were found, if the result has any; the first is exact to the solution's error.
  /// All others (kSeparated among them, which stops before there is an optimum): zero.
  /// kInvalidInput also for NaN or infinity in a pose, a radius, a core or the result, and for a normal whose length is
  /// not 1. kNoInterior also if the sets have no extent along the normal.
  Status status = Status::kInvalidInput;
  PoseGradient<S, L> pose_1, pose_2;
  /// Whether no other normal and no other contact point is optimal. True is certain within the tolerances of
  /// gradient_internal; false says that another may be, or that the result is too inexact to tell.
  bool is_normal_unique = false;
  bool is_contact_unique = false;

  /// Whether the gradient is the derivative; if not, it is an element of the generalized gradient.
  bool IsUnique() const { return is_normal_unique && is_contact_unique; }
};

namespace gradient_internal {

/// Angle by which normals are turned to see which features meet there, radians: below it, facets count as one. Far
/// above the roundoff of a normal, and of the normals of curved sets, which are as exact as the root of their gap.
template <class S>
inline constexpr S kProbeAngle = sizeof(S) == 4 ? S(1e-3) : S(6e-6);

/// Support points that move by more than this part of the sets' size while the normal turns by kProbeAngle are the ends
/// of a flat feature; less, and the surface curves, with a radius of up to half of kFlatness / kProbeAngle = 50 sizes
/// (float: 25). Test: Gradient.LargeEllipsoid_*.
template <class S>
inline constexpr S kFlatness = sizeof(S) == 4 ? S(0.05) : S(6e-4);

/// Edges within this angle are parallel, radians: what kProbeAngle resolves.
template <class S>
inline constexpr S kParallel = kProbeAngle<S>;

/// What the ray has to miss an edge of the Minkowski difference by, for the normal to be unique: as a part of the
/// coordinates that take part, for the roundoff of support points and witness points and the solver's of their sums.
template <class S>
inline constexpr S kResolution = (sizeof(S) == 4 ? 64 : 4096) * kEpsilon<S>;

template <class S>
AngularVector<S, 3> Cross(const Vector<S, 3>& arm, const Vector<S, 3>& force) {
  return arm.cross(force);
}
template <class S>
AngularVector<S, 2> Cross(const Vector<S, 2>& arm, const Vector<S, 2>& force) {
  return AngularVector<S, 2>(arm.x() * force.y() - arm.y() * force.x());
}

/// Directions across a unit normal, as columns.
template <class S>
Eigen::Matrix<S, 3, 2> TangentsOf(const Vector<S, 3>& normal) {
  Eigen::Matrix<S, 3, 2> tangents;
  tangents.col(0) = normal.unitOrthogonal();
  tangents.col(1) = normal.cross(tangents.col(0));
  return tangents;
}
template <class S>
Eigen::Matrix<S, 2, 1> TangentsOf(const Vector<S, 2>& normal) {
  return {-normal.y(), normal.x()};
}

/// A set's boundary about its support point along the normal: where that moves to as the normal turns. World axes, from
/// the set's centre.
template <class Set>
class Boundary {
 public:
  using S = typename Set::Scalar;
  static constexpr int L = kDimension<typename Set::Core>;
  using Point = Vector<S, L>;
  using Tangent = Vector<S, L - 1>;
  using Tangents = Eigen::Matrix<S, L, L - 1>;

  /// @param side  1 for set 1, -1 for set 2, which the normal points into.
  Boundary(const Set& set, const PoseOf<Set>& pose, const Point& normal, const Tangents& tangents, S side)
      : set_(set), rotation_(pose.rotation), outwards_(side * normal), tangents_(tangents), side_(side) {
    local_center_ = set.core.Center();
    center_ = rotation_ * local_center_;
    height_ = outwards_.dot(CoreSupport(outwards_)) + set.radius;
  }

  /// From the pose's origin.
  const Point& Center() const { return center_; }
  /// Of the supporting plane above the centre, metres.
  S Height() const { return height_; }
  /// How far the core reaches from its centre as seen here, metres.
  S Reach() const { return reach_; }

  /// The part across the normal of the support point along normal + kProbeAngle * turn.
  Tangent Probe(const Tangent& turn) {
    const Point along = side_ * kProbeAngle<S> * (tangents_ * turn);
    return tangents_.transpose() * (CoreSupport(outwards_ + along) + set_.radius * along);
  }

  /// The flat part of the boundary across the normal: of 0, 1 or 2 dimensions, and the direction if it is 1.
  struct FlatPart {
    int dimension = 0;
    Tangent direction = Tangent::Zero();
  };
  /// @param least_extent  Of what counts as flat, metres.
  FlatPart FindFlatPart(S least_extent) {
    Tangent longest = Width(Tangent::Unit(0));
    if constexpr (L == 3) {
      const Tangent other = Width(Tangent::Unit(1));
      if (other.squaredNorm() > longest.squaredNorm()) longest = other;
    }
    S length = longest.norm();
    if (!(length > least_extent)) return {};
    if constexpr (L == 3) {
      // Once more along it: what the surface curves across an edge is then of second order in the angle.
      longest = Width(longest / length);
      length = longest.norm();
      if (!(length > least_extent)) return {};
      const Tangent across(-longest.y() / length, longest.x() / length);
      if (std::abs(across.dot(Width(across))) > least_extent) return {2, Tangent::Zero()};
    }
    return {1, longest / length};
  }

 private:
  Point CoreSupport(const Point& direction) {
    const Point local = rotation_.transpose() * direction;
    const Point support = rotation_ * (set_.core.Support(local).point - local_center_);
    reach_ = std::max(reach_, support.norm());
    return support;
  }
  Tangent Width(const Tangent& turn) { return Probe(turn) - Probe(-turn); }

  const Set& set_;
  const SquareMatrix<S, L> rotation_;
  const Point outwards_;
  const Tangents tangents_;
  const S side_;
  Point local_center_, center_;
  S height_ = 0, reach_ = 0;
};

/// Two boundaries that face each other along a normal.
template <class Set1, class Set2>
struct FacingBoundaries {
  using S = typename Set1::Scalar;
  static constexpr int L = kDimension<typename Set1::Core>;
  using Point = Vector<S, L>;
  using Tangent = Vector<S, L - 1>;

  FacingBoundaries(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
                   const Point& normal)
      : tangents(TangentsOf<S>(normal)),
        boundary_1(set_1, pose_1, normal, tangents, S(1)),
        boundary_2(set_2, pose_2, normal, tangents, S(-1)),
        radii(set_1.radius + set_2.radius) {}

  /// Size of the two sets, metres.
  S Size() const { return boundary_1.Reach() + boundary_2.Reach() + radii; }

  /// Whether the flat parts of the two sets have at most one point in common, if they meet where neither ends: that
  /// leaves no direction to both of them.
  bool IsContactUnique() {
    const S least_extent = kFlatness<S> * Size();
    const auto flat_1 = boundary_1.FindFlatPart(least_extent);
    if (flat_1.dimension == 0) return true;
    const auto flat_2 = boundary_2.FindFlatPart(least_extent);
    if (flat_2.dimension == 0) return true;
    if constexpr (L == 3) {
      if (flat_1.dimension + flat_2.dimension > 2) return false;
      const Tangent &a = flat_1.direction, &b = flat_2.direction;
      return std::abs(a.x() * b.y() - a.y() * b.x()) > kParallel<S>;
    }
    return false;
  }

  /// Whether the supporting plane rises on the ray whichever way the normal turns: then no other normal is optimal.
  /// With K the points of the Minkowski difference that are met as the normal turns, seen from where the ray leaves it,
  /// the plane rises at first by <e, q(e)> when the normal turns towards e, q(e) being the support point of K: so the
  /// origin has to be inside K, by more than roundoff.
  /// @param exit       Where the ray leaves: across the normal, metres.
  /// @param tolerance  Metres.
  bool IsNormalUnique(const Tangent& exit, S tolerance) {
    const auto support = [&](const Tangent& turn) -> Tangent {
      return boundary_1.Probe(turn) - boundary_2.Probe(turn) - exit;
    };
    if constexpr (L == 2) {
      return support(Tangent(S(1)))[0] > tolerance && -support(Tangent(S(-1)))[0] > tolerance;
    } else {
      // A polygon of support points, by the angle of their directions, is refined where an edge of it is too near.
      constexpr int kMostPoints = 20;
      std::array<Tangent, kMostPoints> polygon;
      int size = 0;
      for (const Tangent& turn : {Tangent(1, 0), Tangent(0, 1), Tangent(-1, 0), Tangent(0, -1)}) {
        const Tangent point = support(turn);
        if (!(turn.dot(point) > tolerance)) return false;
        polygon[static_cast<std::size_t>(size++)] = point;
      }
      while (size < kMostPoints) {
        int nearest = 0;
        S least = std::numeric_limits<S>::infinity();
        Tangent outwards = Tangent::Zero();
        for (int i = 0; i < size; ++i) {
          const Tangent& from = polygon[static_cast<std::size_t>(i)];
          const Tangent edge = polygon[static_cast<std::size_t>(i + 1 < size ? i + 1 : 0)] - from;
          const S length = edge.norm();
          if (!(length > 0)) continue;
          const Tangent normal(edge.y() / length, -edge.x() / length);
          if (normal.dot(from) < least) {
            least = normal.dot(from);
            nearest = i;
            outwards = normal;
          }
        }
        if (least > tolerance) return true;
        const Tangent point = support(outwards);
        const S distance = outwards.dot(point);
        if (!(distance > tolerance && distance > least)) return false;
        std::move_backward(polygon.begin() + nearest + 1, polygon.begin() + size, polygon.begin() + size + 1);
        polygon[static_cast<std::size_t>(nearest + 1)] = point;
        ++size;
      }
      return false;
    }
  }

  Eigen::Matrix<S, L, L - 1> tangents;
  Boundary<Set1> boundary_1;
  Boundary<Set2> boundary_2;
  S radii;
};

/// Whether poses and a result are made of numbers, and the normal has unit length: support functions take no other.
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
/// @param result  Of SignedDistance(), UpdateDistance() or UpdateOnReferenceFace() for these sets and poses. The normal
///                of sets whose cores overlap is not reported as unique: another one elsewhere may be as good, and the
///                distance is then the larger one of what either says. Neither is that of a result whose bounds differ
///                by more than the root of the scalar's epsilon times the sets' size.
/// As GrowthDistanceGradient() in all else.
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
