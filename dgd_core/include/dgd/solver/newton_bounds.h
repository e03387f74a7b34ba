// What Newton's steps have proven of the ray: the lowest supporting plane, and how far C certainly holds it.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "dgd/assert.h"
#include "dgd/query_types.h"
#include "dgd/solver/query_mode.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// Bounds of a search: see newton.h. Coordinates are in the ray's frame, about the centres, metres, unless said.
template <class MinkowskiDifference>
class NewtonBounds {
 public:
  using Difference = MinkowskiDifference;
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  using Point = Vector<S, L>;

  NewtonBounds(const Difference& difference, const Settings<S>& settings)
      : difference_(difference),
        settings_(settings),
        inner_(difference.Inradius()),
        inner_on_1_(difference.Inradius1() * Point::Unit(L - 1)) {}

  /// Lower bound; at most the upper one, also where roundoff puts the two heights in the wrong order.
  S LowerBound() const { return difference_.CenterDistance() / std::max(outer_, inner_); }
  S UpperBound() const { return difference_.CenterDistance() / inner_; }
  /// Normal of the lowest supporting plane so far; ray frame, unit length.
  Point NormalInFrame() const { return outer_direction_.normalized(); }
  /// The same in the world.
  Point Normal() const { return difference_.DirectionToWorld(NormalInFrame()); }
  /// Distance of the supporting planes along the normal, metres.
  S Separation() const { return (difference_.CenterDistance() - outer_) / outer_direction_.norm(); }
  Point Witness1() const { return difference_.Center1() + difference_.DirectionToWorld(inner_on_1_); }
  Point Witness2() const {
    // They are a multiple of the ray apart.
    return difference_.Center2() + difference_.DirectionToWorld(inner_on_1_ - inner_ * Point::Unit(L - 1));
  }
  /// A point half way between the supporting planes along the normal.
  Point PointBetween() const {
    return difference_.Center1() + difference_.DirectionToWorld(outer_on_1_) + Separation() / 2 * Normal();
  }

  /// Height of the lowest supporting plane so far, metres, and its normal, scaled to height 1.
  S Outer() const { return outer_; }
  const Point& OuterDirection() const { return outer_direction_; }

  void LowerOuter(const Point& direction, S height, const Point& on_1) {
    if (!(height < outer_)) return;
    outer_ = height;
    outer_direction_ = direction;
    outer_on_1_ = on_1;
  }

  /// The hull of a point of C off the ray and of C's ball about the origin contains the ray up to a height between
  /// theirs.
  void RaiseInner(const Point& point, const Point& on_1) {
    DGD_ASSERT(difference_.Inradius() > 0);
    const S inradius = difference_.Inradius();
    const S distance = point.template head<L - 1>().norm();
    const S weight = inradius / (inradius + distance), height = weight * point[L - 1];
    if (!(height > inner_)) return;
    inner_ = height;
    // The ball's point is -inradius / distance times what is across the ray; its weight is distance / inradius times
    // the point's.
    inner_on_1_ = on_1;
    inner_on_1_.template head<L - 1>() -= difference_.Inradius1() / inradius * point.template head<L - 1>();
    inner_on_1_ *= weight;
  }

  /// How the query ends by these bounds; nothing if they do not decide it yet.
  std::optional<Status> Verdict(QueryMode mode) const {
    const S length = difference_.CenterDistance();
    if (outer_ < length && Separation() > settings_.separation_limit) return Status::kSeparated;
    const bool has_converged = outer_ <= inner_ * (1 + settings_.relative_tolerance);
    if (mode == QueryMode::kCollision) {
      if (inner_ >= length) return Status::kColliding;
      if (outer_ < length) return Status::kSeparated;
      if (has_converged) return Status::kTouching;
    } else if (has_converged) {
      return Status::kOptimal;
    }
    return std::nullopt;
  }

 private:
  const Difference& difference_;
  const Settings<S>& settings_;
  S outer_ = std::numeric_limits<S>::infinity();
  Point outer_direction_ = Point::Unit(L - 1);
  Point outer_on_1_ = Point::Zero();  // Point of set 1 on its plane.
  S inner_;                           // Height up to which C certainly holds the ray; metres.
  Point inner_on_1_;                  // Point of set 1 for the ray's point there.
};

}  // namespace dgd::solver_internal
