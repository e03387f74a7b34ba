// What a query has proven of the ray: the outer approximation, which is the one supporting plane of C that meets the
// ray lowest (paper, Sec. III-C1), and how far C certainly holds the ray.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "dgd/assert.h"
#include "dgd/query_types.h"
#include "dgd/types.h"

namespace dgd {

/// What a query is for.
enum class QueryMode {
  kDistance,
  kCollision  ///< A common point, or a plane between the sets.
};

/// Bounds on the growth distance of a pair, and the points that prove them. Coordinates are in the ray's frame, about
/// the centres, metres, unless said.
template <class MinkowskiDifference>
class RayBounds {
 public:
  using Difference = MinkowskiDifference;
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  using Point = Vector<S, L>;

  /// @param inner  A height up to which C holds the ray, > 0 if C has an interior.
  RayBounds(const Difference& difference, const Settings<S>& settings, S inner)
      : difference_(difference), settings_(settings), inner_(inner) {}

  /// Lower bound; at most the upper one, also where roundoff puts the two heights in the wrong order.
  S LowerBound() const { return RayLength() / std::max(outer_, inner_); }
  S UpperBound() const { return RayLength() / inner_; }
  /// Normal of the lowest supporting plane so far; ray frame, unit length.
  Point NormalInFrame() const { return outer_direction_.normalized(); }
  /// The same in the world.
  Point Normal() const { return difference_.DirectionToWorld(NormalInFrame()); }
  /// Distance of the supporting planes along the normal, metres.
  S Separation() const {
    if (!difference_.HasRay()) return -outer_;
    return (difference_.CenterDistance() - outer_) * outer_direction_[L - 1] / outer_direction_.norm();
  }
  Point Witness1() const { return difference_.Center1() + difference_.DirectionToWorld(inner_on_1_); }
  Point Witness2() const { return difference_.Center2() + difference_.DirectionToWorld(inner_on_2_); }
  /// A point half way between the supporting planes along the normal.
  Point PointBetween() const {
    return difference_.Center1() + difference_.DirectionToWorld(outer_on_1_) + Separation() / 2 * Normal();
  }

  /// Height at which the lowest supporting plane so far meets the ray, infinite before the first one, and its normal,
  /// of any length.
  S Outer() const { return outer_; }
  const Point& OuterDirection() const { return outer_direction_; }
  /// Height up to which C holds the ray.
  S Inner() const { return inner_; }

  /// Takes the supporting plane along a direction if it meets the ray lower than all before. Eq.
  /// (outer-approximation-update): the bound is v / <lambda, p>, here the plane's height.
  /// @param direction  Of any length, upwards; where there is no ray, any unit vector, whose plane's distance from the
  ///                   origin counts as its height.
  /// @param on_1       Point of set 1 on its plane.
  void LowerOuter(const Point& direction, S height, const Point& on_1) {
    if (!(height < outer_)) return;  // Also for NaN, which leaves the bounds as they are.
    outer_ = height;
    outer_direction_ = direction;
    outer_on_1_ = on_1;
  }

  /// Takes a height up to which C holds the ray.
  void RaiseInner(S height) { inner_ = std::max(inner_, height); }
  /// Takes the points of set 1 and set 2 whose difference is the ray's point at the inner bound.
  void SetWitness(const Point& on_1, const Point& on_2) {
    inner_on_1_ = on_1;
    inner_on_2_ = on_2;
  }

  /// How the query ends by these bounds; nothing if they do not decide it yet.
  std::optional<Status> Verdict(QueryMode mode) const {
    const S length = difference_.CenterDistance();
    const bool are_apart = outer_ < length;
    if (are_apart && Separation() > settings_.separation_limit) return Status::kSeparated;
    const bool has_converged = outer_ <= inner_ * (1 + settings_.relative_tolerance);
    if (mode == QueryMode::kCollision) {
      if (inner_ >= length) return Status::kColliding;
      if (are_apart) return Status::kSeparated;
      if (has_converged) return Status::kTouching;
    } else if (has_converged) {
      return Status::kOptimal;
    }
    return std::nullopt;
  }

 private:
  /// The centres' distance; 0 where they coincide but for roundoff.
  S RayLength() const { return difference_.HasRay() ? difference_.CenterDistance() : S(0); }

  const Difference& difference_;
  const Settings<S>& settings_;
  S outer_ = std::numeric_limits<S>::infinity();
  Point outer_direction_ = Point::Unit(L - 1);
  Point outer_on_1_ = Point::Zero();
  S inner_;
  Point inner_on_1_ = Point::Zero(), inner_on_2_ = Point::Zero();
};

}  // namespace dgd
