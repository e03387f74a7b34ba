// The Minkowski difference of two posed sets about their centres, seen in the ray's frame.
//
// C = (C1 - p1) - (C2 - p2), Prop. 1 of the paper with the centres at the origin, so that 0 lies inside C and the ray
// runs from 0 along p = p2 - p1. The frame's last axis is the ray: a plane's height on the ray is a coordinate, and
// "the basis holds the ray" is a question across it (Sec. III-D, Numerical Robustness).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/inlining.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// A point of C and the point of set 1 that it comes from; set 2's point is their difference. Ray frame, about the
/// centres, metres.
template <class S, int L = 3>
struct DifferencePoint {
  Vector<S, L> point = Vector<S, L>::Zero();
  Vector<S, L> on_1 = Vector<S, L>::Zero();
  FeatureId feature_1 = kNoFeature;
  FeatureId feature_2 = kNoFeature;

  bool HasFeaturesOf(const DifferencePoint& other) const {
    return feature_1 == other.feature_1 && feature_2 == other.feature_2;
  }
};

/// A support point of one pair of features, and how it moves across the ray with the direction.
template <class S, int L>
struct CurvedDifferencePoint {
  DifferencePoint<S, L> support;
  /// d(point) / d(direction), both across the ray, or along given tangents; metres, positive semidefinite.
  SquareMatrix<S, L - 1> derivative;
};

/// Cores whose features can be found again, so that a point of theirs can follow the direction.
template <class Core>
concept FeatureCore = VertexCore<Core> || SmoothCore<Core>;

/// Columns: two unit vectors orthogonal to the unit vector `axis`, then `axis`; right-handed. It has no branch (Duff et
/// al. 2017, "Building an Orthonormal Basis, Revisited").
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

template <class S>
SquareMatrix<S, 2> FrameAlong(const Vector2<S>& axis) {
  SquareMatrix<S, 2> frame;
  frame << axis.y(), axis.x(), -axis.x(), axis.y();
  return frame;
}

/// Whether a pair is of a size that the scalar can compute with: see kLeastSize. The size is the geometric mean of the
/// inradii and the distance, if that is larger: sheets and needles may be thinner.
/// @param length, inradius  The distance of the centres, and the sum of the inradii, metres; 0 for flat sets, which are
///                          in range.
template <class S>
bool IsInRange(S length, S inradius) {
  constexpr S kLeastSizeSq = kLeastSize<S> * kLeastSize<S>;
  const bool is_large = inradius * std::max(length, inradius) >= kLeastSizeSq || inradius == 0;
  return is_large && inradius <= kGreatestSize<S>;  // False for NaN.
}

/// Whether the interior is more than the roundoff of the points. A set that is far from its own origin for its size, or
/// a needle next to a grain, may have none left; and a tiny radius does not make up for the roundoff of a flat core's
/// centre. Test: GrowthDistanceStatus.InteriorBelowRounding_*.
/// @param point_1, point_2  Any points of the cores, from their origins or centres; in any frame, metres.
template <class Set1, class Set2>
bool HasCertainInterior(const Set1& set_1, const Set2& set_2, const VectorOf<typename Set1::Core>& point_1,
                        const VectorOf<typename Set1::Core>& point_2) {
  using S = typename Set1::Scalar;
  constexpr S kUnits = 4;  // Last digits that a centroid, and a point turned into another frame, are off by.
  const S reach = set_1.core.Center().cwiseAbs().maxCoeff() + set_2.core.Center().cwiseAbs().maxCoeff() +
                  point_1.cwiseAbs().maxCoeff() + point_2.cwiseAbs().maxCoeff();
  return set_1.core.Inradius() + set_2.core.Inradius() + set_1.radius + set_2.radius > kUnits * kEpsilon<S> * reach;
}

template <class Set1, class Set2>
class MinkowskiDifference {
 public:
  using S = typename Set1::Scalar;
  static constexpr int L = kDimension<typename Set1::Core>;
  using Point = Vector<S, L>;
  using Matrix = SquareMatrix<S, L>;
  using Feature = DifferencePoint<S, L>;
  static_assert(std::is_same_v<S, typename Set2::Scalar>, "both sets must have the same scalar");
  static_assert(L == kDimension<typename Set2::Core>, "both sets must have the same dimension");

  /// Points can be found again by the features that gave them.
  static constexpr bool kHasFeatures = FeatureCore<typename Set1::Core> && FeatureCore<typename Set2::Core>;
  /// Points can be found again, and move with the direction.
  static constexpr bool kIsSmooth =
      kHasFeatures && (SmoothCore<typename Set1::Core> || SmoothCore<typename Set2::Core>);

  /// The difference is a polytope, but for the radius.
  static constexpr bool kIsPolytope = kHasFeatures && !kIsSmooth;
  /// Some points are the rims of flat discs.
  static constexpr bool kHasFaces =
      kIsSmooth && L == 3 && (FacedCore<typename Set1::Core> || FacedCore<typename Set2::Core>);

  MinkowskiDifference(const Set1& set_1, const Pose<S, L>& pose_1, const Set2& set_2, const Pose<S, L>& pose_2)
      : set_1_(set_1), set_2_(set_2), core_center_1_(set_1.core.Center()), core_center_2_(set_2.core.Center()) {
    const Point offset_1 = pose_1.rotation * core_center_1_, offset_2 = pose_2.rotation * core_center_2_;
    // cppcheck-suppress useInitializationList
    center_1_ = offset_1 + pose_1.translation;
    // cppcheck-suppress useInitializationList
    center_2_ = offset_2 + pose_2.translation;
    // Not center_2_ - center_1_: far from the world's origin, these have lost digits that the translations' difference
    // has. Test: HardCases, far_away.
    const Point p = (pose_2.translation - pose_1.translation) + (offset_2 - offset_1);
    length_ = p.norm();
    const S radius = set_1.radius + set_2.radius;
    const S core_inradius = set_1.core.Inradius() + set_2.core.Inradius();
    inradius_ = radius + core_inradius;
    // With coincident centres the ray has no direction; any frame serves, see RayIntersection. So tiny a length may
    // also have lost its digits to underflow.
    const bool has_direction =
        length_ > kCoincidence<S> * inradius_ && length_ * length_ >= std::numeric_limits<S>::min();
    if (!has_direction) length_ = p.stableNorm();
    frame_ = has_direction ? FrameAlong<S>(Point(p / length_)) : Matrix::Identity();
    to_frame_1_.noalias() = frame_.transpose() * pose_1.rotation;
    to_frame_2_.noalias() = frame_.transpose() * pose_2.rotation;
    convex_radius_ = radius > kMinConvexRadius<S> * core_inradius ? radius : 0;
    inflation_1_ = convex_radius_ > 0 ? 0 : set_1.radius;
    inflation_2_ = convex_radius_ > 0 ? 0 : set_2.radius;
  }

  /// |p|, metres: the length at which the ray reaches growth distance 1.
  S CenterDistance() const { return length_; }
  /// The difference, about the centres, of the sets' points that coincide in space; metres.
  Point DistanceOrigin() const { return length_ * Point::Unit(L - 1); }
  /// Largest coordinate of a point, metres.
  static S Reach(const Feature& feature) { return feature.point.cwiseAbs().maxCoeff(); }
  /// Whether there is an interior, and the ray has a direction: the centres do not coincide.
  bool HasRay() const { return inradius_ > 0 && length_ > kCoincidence<S> * inradius_; }
  /// Radius of a ball about the origin inside C, metres (eq. inradius). 0 if C has no interior.
  S Inradius() const { return inradius_; }
  /// The part of Inradius() that set 1 contributes.
  S Inradius1() const { return set_1_.core.Inradius() + set_1_.radius; }
  /// The same as dgd::HasCertainInterior(), by any support point.
  bool HasCertainInterior(const Feature& support) const {
    return dgd::HasCertainInterior(set_1_, set_2_, support.on_1, Point(support.on_1 - support.point));
  }
  /// Inradius of the difference that the support points are of: without the ball that is kept apart.
  S InradiusOfPoints() const { return InradiusOfPoints1() + set_2_.core.Inradius() + inflation_2_; }
  /// The part of InradiusOfPoints() that set 1 contributes.
  S InradiusOfPoints1() const { return set_1_.core.Inradius() + inflation_1_; }
  /// A guess at the normal by which the ray leaves: M^-1 p of the ellipsoid whose matrix M is the sum of the cores'
  /// spreads, and of the radii squared; here, along M's last row of cofactors. Ray frame, unit length, not downwards.
  Point EllipsoidGuess() const requires(L == 3) {
    const S radius = set_1_.radius + set_2_.radius;
    Eigen::Matrix<S, 3, 2> columns = radius * radius * Eigen::Matrix<S, 3, 2>::Identity();
    const auto add = [&](const auto& spread, const Matrix& to_frame) {
      columns += to_frame * (spread * to_frame.template topRows<2>().transpose());
    };
    add(SpreadOf(set_1_.core), to_frame_1_);
    add(SpreadOf(set_2_.core), to_frame_2_);
    const S size = columns.template topRows<2>().trace();
    if (!(size > 0)) return Point::UnitZ();
    columns /= size;
    const Point normal = columns.col(0).cross(columns.col(1));
    const S length = normal.norm();
    return length > 0 && normal.z() > 0 ? Point(normal / length) : Point(Point::UnitZ());
  }

  /// Radius of the ball that support points do not include, metres.
  S ConvexRadius() const { return convex_radius_; }

  /// The point of the cores' difference farthest along the unit vector `normal` (ray frame): eq. (5) of the paper.
  /// @param direction  The normal's, of any length.
  /// @param hint_1, hint_2  Features of points of the sets that are likely to be near, for cores that make use of
  ///                        them; any will do.
  DifferencePoint<S, L> Support(const Point& direction, const Point& normal, FeatureId hint_1 = kNoFeature,
                                FeatureId hint_2 = kNoFeature) const {
    DGD_ASSERT(IsUnitOrNan(normal));
    return Difference(SupportNear(set_1_.core, Point(to_frame_1_.transpose() * direction), hint_1),
                      SupportNear(set_2_.core, Point(to_frame_2_.transpose() * -direction), hint_2), normal);
  }

  /// Whether one of the cores is a point or a segment.
  bool HasThinCore() const requires kIsPolytope {
    return std::min(FeatureCount(set_1_.core), FeatureCount(set_2_.core)) <= 2;
  }
  /// Whether both cores have these features; they may have changed since a previous query named them.
  bool HasFeatures(FeatureId feature_1, FeatureId feature_2) const requires kHasFeatures {
    return feature_1 < FeatureCount(set_1_.core) && feature_2 < FeatureCount(set_2_.core);
  }

  /// The difference of two vertices that a previous query named.
  DifferencePoint<S, L> FromVertices(VertexId vertex_1, VertexId vertex_2) const requires kIsPolytope {
    DGD_ASSERT(HasFeatures(vertex_1, vertex_2));
    return Difference({set_1_.core.Vertex(vertex_1), vertex_1}, {set_2_.core.Vertex(vertex_2), vertex_2},
                      Point::Zero());
  }

  /// The point of C, radii included, that is farthest along a direction of any length, and how it moves with that.
  /// @param hint_1, hint_2  As of Support().
  DGD_FLATTEN DGD_NOINLINE CurvedDifferencePoint<S, L> CurvedSupport(const Point& direction, FeatureId hint_1,
                                                                     FeatureId hint_2) const requires kIsSmooth {
    const Point direction_1 = to_frame_1_.transpose() * direction, direction_2 = to_frame_2_.transpose() * -direction;
    return OnFeaturesAlong(FeatureAlong(set_1_.core, direction_1, hint_1),
                           FeatureAlong(set_2_.core, direction_2, hint_2), direction, direction_1, direction_2);
  }
  /// The same of two features.
  DGD_FLATTEN DGD_NOINLINE CurvedDifferencePoint<S, L> OnFeatures(FeatureId feature_1, FeatureId feature_2,
                                                                  const Point& direction) const requires kIsSmooth {
    return OnFeaturesAlong(feature_1, feature_2, direction, to_frame_1_.transpose() * direction,
                           to_frame_2_.transpose() * -direction);
  }

  /// The point of two features that is farthest along a unit vector, radii left out that are kept apart, and how it
  /// moves with that vector, seen across it.
  /// @param tangents  Rows: the unit vectors across `normal` that the derivative is in.
  DGD_FLATTEN DGD_NOINLINE CurvedDifferencePoint<S, L> AlongTangents(
      FeatureId feature_1, FeatureId feature_2, const Point& normal,
      const Eigen::Matrix<S, L - 1, L>& tangents) const requires kIsSmooth {
    DGD_ASSERT(HasFeatures(feature_1, feature_2) && IsUnitOrNan(normal));
    const Eigen::Matrix<S, L - 1, L> across_1 = tangents * to_frame_1_, across_2 = tangents * to_frame_2_;
    const CurvedPoint<S, L> curved_1 = OfFeature(set_1_.core, feature_1, to_frame_1_.transpose() * normal);
    const CurvedPoint<S, L> curved_2 = OfFeature(set_2_.core, feature_2, to_frame_2_.transpose() * -normal);
    CurvedDifferencePoint<S, L> curved{Difference({curved_1.point, feature_1}, {curved_2.point, feature_2}, normal),
                                       (inflation_1_ + inflation_2_) * SquareMatrix<S, L - 1>::Identity()};
    AddDerivative<typename Set1::Core>(across_1, curved_1, curved.derivative);
    AddDerivative<typename Set2::Core>(across_2, curved_2, curved.derivative);
    return curved;
  }

  /// The flat disc that a feature of set 1 (of set 2, less its centre and turned over, as it takes part in C) bounds,
  /// if any; ray frame, about the centres.
  FlatDisc<S> Face1(FeatureId feature) const requires(L == 3) {
    return FaceOf(set_1_.core, core_center_1_, to_frame_1_, feature, 1);
  }
  FlatDisc<S> Face2(FeatureId feature) const requires(L == 3) {
    return FaceOf(set_2_.core, core_center_2_, to_frame_2_, feature, -1);
  }
  /// Radii of the sets, metres.
  S Radius1() const { return set_1_.radius; }
  S Radius2() const { return set_2_.radius; }

  Point DirectionToFrame(const Point& direction_1) const { return to_frame_1_ * direction_1; }
  /// Normal in the frame of set 1, of unit length also where a rotation from an engine in float is not quite
  /// orthonormal.
  Point NormalOfSet1(const Point& direction) const { return (to_frame_1_.transpose() * direction).normalized(); }
  Point DirectionToWorld(const Point& direction) const { return frame_ * direction; }
  Point DirectionFromWorld(const Point& direction) const { return frame_.transpose() * direction; }

  /// Points of set 1 and set 2, from the cores' points; ray frame, about the centres.
  Point OnSet1(const Point& core_point, const Point& normal) const {
    return core_point + (convex_radius_ > 0 ? set_1_.radius : S(0)) * normal;
  }
  Point OnSet2(const Point& core_point, const Point& normal) const {
    return core_point - (convex_radius_ > 0 ? set_2_.radius : S(0)) * normal;
  }
  /// The same in the world.
  Point World1(const Point& core_point, const Point& normal) const {
    return center_1_ + frame_ * OnSet1(core_point, normal);
  }
  Point World2(const Point& core_point, const Point& normal) const {
    return center_2_ + frame_ * OnSet2(core_point, normal);
  }
  /// Error of support points beyond the scalar's roundoff, relative to their size.
  S Accuracy() const { return std::max(AccuracyOf(set_1_.core), AccuracyOf(set_2_.core)); }
  const Point& Center1() const { return center_1_; }
  const Point& Center2() const { return center_2_; }

  /// False for NaN or infinity anywhere in the poses or radii, and for sizes out of the scalar's range; those of flat
  /// sets show in their points alone.
  bool IsValid() const {
    const S sum = to_frame_1_.sum() + to_frame_2_.sum() + length_ + inradius_ + center_1_.sum() + center_2_.sum();
    return std::isfinite(sum) && IsInRange(length_, inradius_);
  }

 private:
  template <class Core>
  static S AccuracyOf([[maybe_unused]] const Core& core) {
    if constexpr (InexactCore<Core>) {
      return core.Accuracy();
    } else {
      return 0;
    }
  }

  template <FeatureCore Core>
  static FeatureId FeatureCount(const Core& core) {
    if constexpr (SmoothCore<Core>) {
      return core.PieceCount();
    } else {
      return core.VertexCount();
    }
  }

  /// The feature of the support point. Where there is but one, nothing is evaluated.
  template <FeatureCore Core>
  static FeatureId FeatureAlong(const Core& core, const Point& direction, FeatureId hint) {
    if constexpr (SmoothCore<Core>) {
      if (core.PieceCount() == 1) return 0;
    }
    return SupportNear(core, direction, hint).feature;
  }

  template <FeatureCore Core>
  static CurvedPoint<S, L> OfFeature(const Core& core, FeatureId feature, [[maybe_unused]] const Point& direction) {
    if constexpr (SmoothCore<Core>) {
      return core.PieceSupport(feature, direction);
    } else {
      return {core.Vertex(feature), Matrix::Zero()};
    }
  }

  template <class Core>
  static FlatDisc<S> FaceOf([[maybe_unused]] const Core& core, [[maybe_unused]] const Point& center,
                            [[maybe_unused]] const Matrix& to_frame, [[maybe_unused]] FeatureId feature,
                            [[maybe_unused]] S side) {
    if constexpr (FacedCore<Core>) {
      const FlatDisc<S> face = core.Face(feature);
      // The pose may have been rounded to float: its rotation does not quite keep lengths.
      const Point normal = side * (to_frame * face.normal);
      if (normal.isZero(0)) return {};
      return {normal.normalized(), side * (to_frame * (face.center - center)), face.radius};
    } else {
      return {};
    }
  }

  CurvedDifferencePoint<S, L> OnFeaturesAlong(FeatureId feature_1, FeatureId feature_2, const Point& direction,
                                              const Point& direction_1,
                                              const Point& direction_2) const requires kIsSmooth {
    DGD_ASSERT(HasFeatures(feature_1, feature_2));
    const CurvedPoint<S, L> curved_1 = OfFeature(set_1_.core, feature_1, direction_1);
    const CurvedPoint<S, L> curved_2 = OfFeature(set_2_.core, feature_2, direction_2);
    CurvedDifferencePoint<S, L> curved{CoreDifference({curved_1.point, feature_1}, {curved_2.point, feature_2}),
                                       SquareMatrix<S, L - 1>::Zero()};
    AddDerivative<typename Set1::Core>(to_frame_1_.template topRows<L - 1>(), curved_1, curved.derivative);
    AddDerivative<typename Set2::Core>(to_frame_2_.template topRows<L - 1>(), curved_2, curved.derivative);
    const S radius = set_1_.radius + set_2_.radius;
    if (radius != 0) {
      const S length = direction.norm();
      const Point normal = direction / length;
      curved.support.on_1 += set_1_.radius * normal;
      curved.support.point += radius * normal;
      const Vector<S, L - 1> across = normal.template head<L - 1>();
      curved.derivative += radius / length * (SquareMatrix<S, L - 1>::Identity() - across * across.transpose());
    }
    return curved;
  }

  /// A core's part of the derivative; vertices have none.
  /// @param across  The core's frame to the two axes that it is seen along.
  template <FeatureCore Core, class Across>
  static void AddDerivative([[maybe_unused]] const Across& across, [[maybe_unused]] const CurvedPoint<S, L>& curved,
                            [[maybe_unused]] SquareMatrix<S, L - 1>& derivative) {
    if constexpr (SmoothCore<Core>) derivative += across * curved.derivative * across.transpose();
  }

  DifferencePoint<S, L> Difference(const SupportPoint<S, L>& support_1, const SupportPoint<S, L>& support_2,
                                   const Point& normal) const {
    DifferencePoint<S, L> difference = CoreDifference(support_1, support_2);
    if (convex_radius_ == 0) {
      // Tiny radii belong to the support points: see kMinConvexRadius.
      difference.on_1 += inflation_1_ * normal;
      difference.point += (inflation_1_ + inflation_2_) * normal;
    }
    return difference;
  }

  DifferencePoint<S, L> CoreDifference(const SupportPoint<S, L>& support_1, const SupportPoint<S, L>& support_2) const {
    DifferencePoint<S, L> difference;
    difference.on_1.noalias() = to_frame_1_ * (support_1.point - core_center_1_);
    difference.point.noalias() = to_frame_2_ * (core_center_2_ - support_2.point);
    difference.point += difference.on_1;
    difference.feature_1 = support_1.feature;
    difference.feature_2 = support_2.feature;
    return difference;
  }

  const Set1& set_1_;
  const Set2& set_2_;
  Point core_center_1_, core_center_2_;  // Centres in the cores' frames.
  Point center_1_, center_2_;            // Centres in the world.
  Matrix frame_;                         // Ray frame to world.
  Matrix to_frame_1_, to_frame_2_;       // Cores' frames to the ray frame.
  S length_, inradius_, convex_radius_, inflation_1_, inflation_2_;
};

}  // namespace dgd
