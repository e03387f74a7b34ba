// What a search for the signed distance has proven: the best supporting plane that it met, and the point of its inner
// approximation that is nearest to the origin.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"

namespace dgd::distance_internal {

/// Bounds on the signed distance of the difference K of two cores, about the origin of the two positions: see
/// signed_distance_search.h. GJK and the expanding polytope read and write them. Lengths in metres, in the axes of the
/// difference.
template <class DifferenceOfCores>
struct DistanceBounds {
  using Difference = DifferenceOfCores;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  using Feature = DifferencePoint<S, 3>;
  /// Rows: two unit vectors across a normal, and across each other.
  using Tangents = Eigen::Matrix<S, 2, 3>;
  static_assert(Difference::L == 3, "the signed distance is for sets in space");

  /// A supporting plane of K.
  struct Plane {
    Point normal;
    S height = std::numeric_limits<S>::infinity();  ///< Over the origin; metres.
    Feature support;                                ///< A point on it, if it was met by Cut().
    bool has_support = false;
    bool is_new = false;  ///< No Newton's step was taken from it yet.
  };

  template <class Set1, class Set2>
  DistanceBounds(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
                 const Settings<S>& query_settings)
      : difference(set_1, pose_1, set_2, pose_2), settings(query_settings) {}

  /// Unit normal of the best plane, in the world.
  Point Normal() const { return difference.DirectionToWorld(best.normal); }
  /// Separation of the sets, radii included, along that normal; metres.
  S Separation() const { return -best.height - difference.ConvexRadius(); }
  S UpperBound() const { return std::max(nearest + SupportError(), -best.height) - difference.ConvexRadius(); }
  Point Witness1() const { return difference.World1(foot.on_1, best.normal); }
  Point Witness2() const {
    return difference.World2(foot.on_1 - foot.point - difference.DistanceOrigin(), best.normal);
  }

  /// A point of K about the origin of the two positions, instead of the centres.
  Feature ToDistanceOrigin(Feature point) {
    size = std::max(size, Difference::Reach(point));
    point.point -= difference.DistanceOrigin();
    return point;
  }

  /// Largest length that was met, of points of K, the centres' distance, and R; metres.
  S Extent() const { return std::max({size, difference.CenterDistance(), difference.ConvexRadius()}); }
  /// How far points of K may be off, and what is left of their digits next to R; metres.
  S RoundoffBound() const { return kUnits * kEpsilon<S> * Extent(); }
  /// The same with the error of inexact cores, whose same vertex met twice may not be the same point.
  S SupportError() const { return std::max(RoundoffBound(), difference.Accuracy() * size); }
  /// Largest gap of an optimal result, metres; polytopes end at roundoff.
  S Tolerance() const {
    return Difference::kIsPolytope ? RoundoffBound() : std::max(RoundoffBound(), settings.relative_tolerance * size);
  }
  bool IsOptimal() const { return nearest + best.height <= Tolerance(); }
  bool IsExhausted() const { return iterations >= settings.max_iterations; }

  /// Evaluates the support functions along a unit vector, and takes the plane there if it is the best so far.
  /// @return the point of K on that plane.
  Feature Cut(const Point& normal) {
    DGD_ASSERT(IsUnitOrNan(normal));
    ++iterations;
    const Feature support =
        ToDistanceOrigin(difference.Support(normal, normal, best.support.feature_1, best.support.feature_2));
    const S height = normal.dot(support.point);
    if (height < best.height) {
      best.normal = normal;
      best.height = height;
      best.support = support;
      best.has_support = best.is_new = true;
    }
    return support;
  }
  /// The same where it is rare.
  DGD_NOINLINE Feature CutOutOfLine(const Point& normal) { return Cut(normal); }

  static Tangents TangentsAt(const Point& normal) {
    DGD_ASSERT(IsUnitOrNan(normal));
    const Matrix3<S> frame = FrameAlong<S>(normal);
    Tangents tangents;
    tangents << frame.col(0).transpose(), frame.col(1).transpose();
    return tangents;
  }

  /// Keeps the point of the inner approximation for the witness points; or a support point that is nearer to the
  /// plane's foot, as of smooth sets it is. Each witness point is put on its set's supporting plane, which the inner
  /// approximation is below by the gap.
  /// @param status  How the search ended, unless the bounds agree all the same, or there is no plane: of support
  ///                functions that return no numbers.
  Status Finish(Status status, const Feature& of_inner) {
    if (!(best.height < std::numeric_limits<S>::infinity())) return Status::kInvalidInput;
    DGD_ASSERT(IsUnitOrNan(best.normal));
    foot = of_inner;
    if (best.has_support) {
      const Feature& support = best.support;
      if constexpr (!Difference::kIsPolytope) {
        const Point ideal = best.height * best.normal;
        if ((support.point - ideal).squaredNorm() < (foot.point - ideal).squaredNorm()) foot = support;
      }
      foot.on_1 += best.normal.dot(support.on_1 - foot.on_1) * best.normal;
      foot.point += best.normal.dot(support.point - foot.point) * best.normal;
    }
    return IsOptimal() ? Status::kOptimal : status;
  }

  const Difference difference;
  const Settings<S>& settings;
  int iterations = 0;  ///< Evaluations of the support functions.
  S size = 0;          ///< Largest coordinate of a point of K about the centres.
  Plane best;
  S nearest = std::numeric_limits<S>::infinity();  ///< Signed distance of K's inner approximation, metres.
  Feature foot;                                    ///< Difference of the witness points, without radii.

 private:
  /// The roundoff of a point of K, in last digits of its largest coordinate.
  static constexpr S kUnits = 8;
};

}  // namespace dgd::distance_internal
