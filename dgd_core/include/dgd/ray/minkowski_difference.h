// The Minkowski difference of two posed sets about their centres, seen in the ray's frame.
//
// C = (C1 - p1) - (C2 - p2), Prop. 1 of the paper with the centres at the origin, so that 0 lies inside C and the ray
// runs from 0 along p = p2 - p1. The frame's z axis is the ray: a plane's height on the ray is a coordinate, and "the
// basis holds the ray" is a question in the plane (Sec. III-D, Numerical Robustness).
#pragma once

#include <cmath>

#include "dgd/convex_set.h"
#include "dgd/ray/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// A point of C and the point of set 1 that it comes from; set 2's point is their difference. Ray frame, about the
/// centres, metres.
template <class S>
struct DifferencePoint {
  Vector3<S> point = Vector3<S>::Zero();
  Vector3<S> on_1 = Vector3<S>::Zero();
  VertexId feature_1 = kNoFeature;
  VertexId feature_2 = kNoFeature;
};

/// Columns: two unit vectors orthogonal to the unit vector `axis`, then `axis`; right-handed. By the sign of one
/// coordinate, without a branch that could make nearly equal axes take different paths far apart (Duff et al. 2017,
/// "Building an Orthonormal Basis, Revisited").
template <class S>
Matrix3<S> FrameAlong(const Vector3<S>& axis) {
  const S sign = std::copysign(S(1), axis.z());
  const S a = -1 / (sign + axis.z());
  const S b = axis.x() * axis.y() * a;
  Matrix3<S> frame;
  frame.col(0) << 1 + sign * axis.x() * axis.x() * a, sign * b, -sign * axis.x();
  frame.col(1) << b, sign + axis.y() * axis.y() * a, -axis.y();
  frame.col(2) = axis;
  return frame;
}

template <class Set1, class Set2>
class MinkowskiDifference {
 public:
  using S = typename Set1::Scalar;

  MinkowskiDifference(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : set_1_(set_1), set_2_(set_2), core_center_1_(set_1.core.Center()), core_center_2_(set_2.core.Center()) {
    center_1_ = pose_1 * core_center_1_;
    center_2_ = pose_2 * core_center_2_;
    const Vector3<S> p = center_2_ - center_1_;
    length_ = p.norm();
    const S radius = set_1.radius + set_2.radius;
    const S core_inradius = set_1.core.Inradius() + set_2.core.Inradius();
    inradius_ = radius + core_inradius;
    // With coincident centres the ray has no direction; any frame serves, see RayIntersection. So tiny a length may
    // also have lost its digits to underflow.
    frame_ = length_ > kCoincidence<S> * inradius_ ? FrameAlong<S>(p / length_) : Matrix3<S>::Identity();
    to_frame_1_.noalias() = frame_.transpose() * pose_1.rotation;
    to_frame_2_.noalias() = frame_.transpose() * pose_2.rotation;
    rounding_ = radius > kMinRounding<S> * core_inradius ? radius : 0;
    inflation_1_ = rounding_ > 0 ? 0 : set_1.radius;
    inflation_2_ = rounding_ > 0 ? 0 : set_2.radius;
  }

  /// |p|, metres: the length at which the ray reaches growth distance 1.
  S Length() const { return length_; }
  /// Radius of a ball about the origin inside C, metres (eq. inradius). 0 if C has no certain interior.
  S Inradius() const { return inradius_; }
  /// Part of the inradius that set 1 contributes; in [0, 1]. Valid for Inradius() > 0.
  S InradiusShare1() const { return (set_1_.core.Inradius() + set_1_.radius) / inradius_; }
  /// Radius of the ball that is kept apart from the support points, metres; 0 if they include it.
  S Rounding() const { return rounding_; }

  /// The point of the cores' difference farthest along the unit vector `normal` (ray frame): eq. (5) of the paper.
  DifferencePoint<S> Support(const Vector3<S>& normal) const {
    const SupportPoint<S> support_1 = set_1_.core.Support(to_frame_1_.transpose() * normal);
    const SupportPoint<S> support_2 = set_2_.core.Support(to_frame_2_.transpose() * -normal);
    return Difference(support_1, support_2, normal);
  }

  /// Whether both cores have these vertices; they may have changed since a previous query named them.
  bool HasVertices(VertexId feature_1, VertexId feature_2) const requires VertexCore<typename Set1::Core> &&
      VertexCore<typename Set2::Core> {
    return feature_1 < set_1_.core.VertexCount() && feature_2 < set_2_.core.VertexCount();
  }

  /// The difference of two vertices that a previous query named.
  DifferencePoint<S> FromVertices(VertexId feature_1, VertexId feature_2) const requires
      VertexCore<typename Set1::Core> && VertexCore<typename Set2::Core> {
    return Difference({set_1_.core.Vertex(feature_1), feature_1}, {set_2_.core.Vertex(feature_2), feature_2},
                      Vector3<S>::Zero());
  }

  Vector3<S> DirectionToFrame(const Vector3<S>& direction_1) const { return to_frame_1_ * direction_1; }
  Vector3<S> DirectionToSet1(const Vector3<S>& direction) const { return to_frame_1_.transpose() * direction; }
  Vector3<S> DirectionToWorld(const Vector3<S>& direction) const { return frame_ * direction; }

  /// World points of set 1 and set 2, from the cores' points in the ray frame about the centres.
  Vector3<S> World1(const Vector3<S>& core_point, const Vector3<S>& normal) const {
    return center_1_ + frame_ * (core_point + (rounding_ > 0 ? set_1_.radius : S(0)) * normal);
  }
  Vector3<S> World2(const Vector3<S>& core_point, const Vector3<S>& normal) const {
    return center_2_ + frame_ * (core_point - (rounding_ > 0 ? set_2_.radius : S(0)) * normal);
  }
  const Vector3<S>& Center1() const { return center_1_; }
  const Vector3<S>& Center2() const { return center_2_; }

  /// False for NaN or infinity anywhere in the poses or radii.
  bool IsFinite() const {
    const S sum = to_frame_1_.sum() + to_frame_2_.sum() + length_ + inradius_ + center_1_.sum() + center_2_.sum();
    return std::isfinite(sum);
  }

 private:
  DifferencePoint<S> Difference(const SupportPoint<S>& support_1, const SupportPoint<S>& support_2,
                                const Vector3<S>& normal) const {
    DifferencePoint<S> difference;
    difference.on_1.noalias() = to_frame_1_ * (support_1.point - core_center_1_);
    difference.point.noalias() = to_frame_2_ * (core_center_2_ - support_2.point);
    difference.point += difference.on_1;
    if (rounding_ == 0) {
      // Tiny radii belong to the support points: see kMinRounding.
      difference.on_1 += inflation_1_ * normal;
      difference.point += (inflation_1_ + inflation_2_) * normal;
    }
    difference.feature_1 = support_1.feature;
    difference.feature_2 = support_2.feature;
    return difference;
  }

  const Set1& set_1_;
  const Set2& set_2_;
  Vector3<S> core_center_1_, core_center_2_;  // In the cores' frames.
  Vector3<S> center_1_, center_2_;            // In the world.
  Matrix3<S> frame_;                          // Ray frame to world.
  Matrix3<S> to_frame_1_, to_frame_2_;        // Cores' frames to the ray frame.
  S length_, inradius_, rounding_, inflation_1_, inflation_2_;
};

}  // namespace dgd
