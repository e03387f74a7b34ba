// How portal refinement begins where nothing is known of a pair: three corners that the ray passes between, far out.
//
// In the ball about the centre that is inside the cores' difference (Alg. 1), and then from three directions about the
// ray. Two of them and the ball may already decide a collision check. For large hulls no support function is evaluated
// while points that are looked up (GuessingCore) are above the triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "dgd/inlining.h"
#include "dgd/solver/ball_hull.h"
#include "dgd/solver/portal_support.h"
#include "dgd/solver/tolerances.h"

namespace dgd::solver_internal {

template <class Set1, class Set2>
class PortalDiscovery : public PortalSupport<Set1, Set2> {
 public:
  using Support = PortalSupport<Set1, Set2>;
  using Support::Support;
  using typename Support::Point;
  using typename Support::S;

  /// Gives a cold start its first corner, which is the one along the ray.
  /// @param support_1, support_2  Of the cores along the ray; their frames.
  void StartFrom(const SupportPoint<S>& support_1, const SupportPoint<S>& support_2) {
    first_ = CornerOf(support_1, support_2);
  }

 protected:
  using Support::CornerAlong;
  using Support::CornerOf;
  using Support::corners_;
  using Support::FromCenter1;
  using Support::GuessAlong;
  using Support::HasInterior;
  using Support::hint_1_;
  using Support::hint_2_;
  using Support::iterations_;
  using Support::normal_;
  using Support::NormalOfCorners;
  using Support::pose_1_;
  using Support::radius_;
  using Support::ray_;
  using Support::set_1_;
  using Support::set_2_;
  using typename Support::Corner;

  Corner FirstCorner(const Point& axis, bool may_guess) {
    if (!first_) return may_guess ? GuessAlong(axis) : CornerAlong(axis);
    ++iterations_;
    return *first_;
  }

  /// A refinement of large hulls without a support function, as far as looked-up points go. Queries of hulls of 241 to
  /// 4516 vertices take 0.6 of the time that they take with support points from the first direction on.
  /// @tparam kIsCheck  Whether a triangle beyond the ray's end is enough.
  template <bool kIsCheck>
  DGD_FLATTEN DGD_NOINLINE bool StartByGuesses(const Point& axis, const Corner& first) {
    // Guesses that raise the triangle by less are left to the support functions. By measurement, without a limit
    // queries take as long, and with 1e-2 those of 2000 vertices a sixth longer.
    constexpr S kWorthwhile = S(1e-3);
    // Roundoff, and radii, must not make them go round in circles.
    constexpr int kMost = 16;
    if (!DiscoverPortal<true, kIsCheck>(axis, first)) return false;
    if (kIsCheck && common_) return true;
    for (int i = 0; i < kMost; ++i) {
      normal_ = NormalOfCorners();
      const S height = radius_ > 0 ? this->template Height<true>() : this->template Height<false>();
      if (!(height > 0)) return false;
      if (kIsCheck && EndsBelow(normal_.dot(ray_), height)) return true;
      const Corner guess = GuessAlong(normal_);
      hint_1_ = guess.feature_1;
      hint_2_ = guess.feature_2;
      if (!(normal_.dot(guess.point - corners_[0].point) > kWorthwhile * height)) return true;
      if (!(radius_ > 0 ? this->template RefinePortal<true>(guess) : this->template RefinePortal<false>(guess)))
        return false;
    }
    return true;
  }

  /// Along the ray, and then twice tilted to the far side of the ray from what was found: by more where that was far
  /// away. With three corners near the ray, hulls of 14, 32, 241 and 2000 vertices take 3, 9, 19 and 20 % fewer
  /// directions than with normals from the ball on; with a spread of 1.2 or 2 up to 6 % more than with this one.
  /// @tparam kGuess    Whether corners are looked up, or support points.
  /// @tparam kIsCheck  Whether a common point is enough.
  /// @param first      Along the ray.
  /// @return false where roundoff leaves no triangle about the ray.
  template <bool kGuess, bool kIsCheck>
  bool DiscoverPortal(const Point& axis, const Corner& first) {
    constexpr S kSpread = S(1.5);
    // With twice and four times as much, hulls of 241 vertices, ten times as long as thick, take 1 and 3 % more.
    constexpr S kNearSq = S(0.5);
    // A hull's point that is farther out by less than so much is not looked at. By measurement, checks of hulls that
    // touch take 4 % less by that, and of hulls 1 m across that are 5 to 15 cm deep as long.
    constexpr S kWellInside = S(1.2);
    const auto along = [this](const Point& direction) {
      return kGuess ? GuessAlong(direction) : CornerAlong(direction);
    };
    const S height = axis.dot(first.point);
    const Point lateral = first.point - height * axis;
    // Of skewed sets, what is farthest along the ray is far from it, and so is what is found like that.
    if (lateral.squaredNorm() > kNearSq * height * height) return this->template RefinePortal<false>(first);
    const Corner second = along(height * axis - kSpread * lateral);
    if (kIsCheck && !wants_corners_ && height * height > kWellInside * kWellInside * ray_.squaredNorm() &&
        FindCommonPoint(axis, first, second)) {
      return true;
    }
    const Point across = axis.cross(second.point - first.point);
    const S width_sq = across.squaredNorm(), side = across.dot(first.point);
    if (!this->template RefinePortal<false>(first) || !this->template RefinePortal<false>(second)) return false;
    if (!(width_sq > kEpsilon<S> * height * height)) return true;
    // Half the line's length at least, where that nearly meets the ray.
    const S tilt = kSpread * std::max(std::abs(side) / width_sq, S(0.5));
    return this->template RefinePortal<false>(along(height * axis - std::copysign(tilt, side) * across));
  }

  /// Finds a common point in the hull of the ball about the centre and of the point between two corners that is nearest
  /// to the ray.
  bool FindCommonPoint(const Point& axis, const Corner& a, const Corner& b) {
    const S height = axis.dot(a.point);
    const Point between = b.point - a.point;
    const Point lateral = a.point - height * axis, step = between - axis.dot(between) * axis;
    const S step_sq = step.squaredNorm();
    const S part = step_sq > 0 ? std::clamp(-lateral.dot(step) / step_sq, S(0), S(1)) : S(0);
    const S inradius_1 = set_1_.core.Inradius() + set_1_.radius, inradius_2 = set_2_.core.Inradius() + set_2_.radius;
    const S inradius = inradius_1 + inradius_2;
    const auto end = FindInBallHull<S, 3>(ray_, a.point + part * between, inradius);
    if (!end || !HasInterior(a)) return false;
    const Point of_corners = (1 - part) * FromCenter1(a.feature_1) + part * FromCenter1(b.feature_1);
    common_ = pose_1_.rotation * set_1_.core.Center() + end->share * of_corners + inradius_1 / inradius * end->inside;
    return true;
  }

  /// Whether the ray ends below the corners, moved by the radius, and between them. With a radius they may be turned
  /// away from the ray, and their plane, moved, is no bound then.
  bool EndsBelow(S along, S height) { return along > 0 && along <= height && this->LeavesByFacet(); }

  std::optional<Corner> first_;  // The farthest along the ray, if known.
  std::optional<Point> common_;  // A common point of the two sets, from set 1's origin; world.
  bool wants_corners_ = true;    // Whether a next query is to begin from corners: a common point would leave none.
};

}  // namespace dgd::solver_internal
