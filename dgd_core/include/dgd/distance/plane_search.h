// The supporting planes that a search for the signed distance meets: one for each direction, and the best of them.
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

/// Of the difference K of two cores, in the ray's frame, about the origin of the two positions: see
/// signed_distance_search.h. Lengths in metres.
template <class Set1, class Set2>
class PlaneSearch {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  using Feature = DifferencePoint<S, 3>;
  static_assert(Difference::L == 3, "the signed distance is for sets in space");

  PlaneSearch(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
              const Settings<S>& settings)
      : difference_(set_1, pose_1, set_2, pose_2), origin_(0, 0, difference_.CenterDistance()), settings_(settings) {}

  /// Evaluations of the support functions.
  int Iterations() const { return iterations_; }
  /// Of the best plane; world, unit length.
  Point Normal() const { return difference_.DirectionToWorld(best_.normal); }
  /// Of the sets, radii included, along that normal; metres.
  S Separation() const { return -best_.height - difference_.ConvexRadius(); }

 protected:
  /// A supporting plane of K.
  struct Plane {
    Point normal;
    S height = std::numeric_limits<S>::infinity();  ///< Over the origin; metres.
    Feature support;                                ///< A point on it, if it was met by Cut().
    bool has_support = false;
  };

  /// A point of K about the origin of the two positions, instead of the centres.
  Feature ToDistanceOrigin(Feature point) {
    size_ = std::max(size_, point.point.cwiseAbs().maxCoeff());
    point.point -= origin_;
    return point;
  }

  /// How far points of K may be off, and what is left of their digits next to R; metres.
  S RoundoffBound() const {
    return kUnits * kEpsilon<S> * std::max({size_, difference_.CenterDistance(), difference_.ConvexRadius()});
  }
  /// The same with the error of inexact cores, whose same vertex met twice may not be the same point.
  S SupportError() const { return std::max(RoundoffBound(), difference_.Accuracy() * size_); }
  /// Largest gap of an optimal result, metres; polytopes end at roundoff.
  S Tolerance() const {
    return Difference::kIsPolytope ? RoundoffBound() : std::max(RoundoffBound(), settings_.relative_tolerance * size_);
  }
  bool IsExhausted() const { return iterations_ >= settings_.max_iterations; }

  /// Evaluates the support functions along a unit vector, and takes the plane there if it is the best so far. Not
  /// inlined: it is called from many places.
  /// @return the point of K on that plane.
  DGD_NOINLINE Feature Cut(const Point& normal) {
    DGD_ASSERT(IsUnitOrNan(normal));
    ++iterations_;
    const Feature support =
        ToDistanceOrigin(difference_.Support(normal, normal, best_.support.feature_1, best_.support.feature_2));
    const S height = normal.dot(support.point);
    if (height < best_.height) {
      best_ = {normal, height, support, true};
      is_news_ = true;
      is_stationary_ = false;
    }
    return support;
  }

  /// Rows: two unit vectors across a normal, and across each other.
  using Tangents = Eigen::Matrix<S, 2, 3>;
  static Tangents TangentsAt(const Point& normal) {
    DGD_ASSERT(IsUnitOrNan(normal));
    const Matrix3<S> frame = FrameAlong<S>(normal);
    Tangents tangents;
    tangents << frame.col(0).transpose(), frame.col(1).transpose();
    return tangents;
  }

  const Difference difference_;
  const Point origin_;  // Of the two positions, from the centres' difference.
  const Settings<S>& settings_;
  S size_ = 0;  // Largest coordinate of a point of K about the centres.
  Plane best_;
  bool is_news_ = false;        // No Newton's step was taken from the best plane yet.
  bool is_stationary_ = false;  // The best plane's normal is the best nearby.

 private:
  /// The roundoff of a point of K, in last digits of its largest coordinate.
  static constexpr S kUnits = 8;

  int iterations_ = 0;
};

}  // namespace dgd::distance_internal
