// How portal refinement begins where nothing is known of a pair: three corners that the ray passes between, far out.
//
// They begin in the ball about the centre that is inside the cores' difference (Alg. 1), and then come from three
// directions about the ray. Two of them and the ball may already decide a collision check. For large hulls no support
// function is evaluated while points that are looked up (GuessingCore) are above the triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "dgd/inlining.h"
#include "dgd/solver/ball_hull.h"
#include "dgd/solver/portal_support.h"
#include "dgd/solver/tolerances.h"

namespace dgd::solver_internal {

/// A portal's first three corners. Reads and writes the portal and the support functions that it is given.
template <class Set1, class Set2>
class PortalDiscovery {
 public:
  using Support = PortalSupport<Set1, Set2>;
  using Corner = typename Support::Corner;
  using Point = typename Support::Point;
  using S = typename Support::S;

  PortalDiscovery(Portal<S>& portal, Support& support) : portal_(portal), support_(support) {}

  /// Gives a cold start its first corner, which is the one along the ray.
  void StartFrom(const Corner& first) { first_ = first; }
  /// A common point is enough: no next query is to begin from corners, of which it would leave none.
  void NeedNoCorners() { wants_corners_ = false; }

  /// The corner along the ray.
  /// @param may_guess  Whether it may be one that is looked up.
  Corner FirstCorner(const Point& axis, bool may_guess) {
    if (!first_) return may_guess ? support_.GuessAlong(axis) : support_.CornerAlong(axis);
    ++support_.iterations;
    return *first_;
  }

  /// Whether three corners were found; in a check, or a common point.
  template <bool kIsCheck>
  bool Discover(const Point& axis, const Corner& first) {
    return support_.HasFastColdStart() ? StartByGuesses<kIsCheck>(axis, first)
                                       : DiscoverPortal<false, kIsCheck>(axis, first);
  }
  /// A common point of the two sets, from set 1's origin, if one was found; world.
  const std::optional<Point>& CommonPoint() const { return common_; }

 private:
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
      portal_.normal = portal_.NormalOfCorners();
      const S height = portal_.radius > 0 ? portal_.template Height<true>() : portal_.template Height<false>();
      if (!(height > 0)) return false;
      if (kIsCheck && portal_.EndsBelow(portal_.normal.dot(portal_.ray), height)) return true;
      const Corner guess = support_.GuessAlong(portal_.normal);
      support_.SearchNear(guess);
      if (!(portal_.normal.dot(guess.point - portal_.corners[0].point) > kWorthwhile * height)) return true;
      const bool is_refined =
          portal_.radius > 0 ? portal_.template RefinePortal<true>(guess) : portal_.template RefinePortal<false>(guess);
      if (!is_refined) return false;
    }
    return true;
  }

  /// Searches along the ray, and then twice tilted to the far side of the ray from what was found: by more where that
  /// was far away. With three corners near the ray, hulls of 14, 32, 241 and 2000 vertices take 3, 9, 19 and 20 % fewer
  /// directions than with normals from the ball on; with a spread of 1.2 or 2 up to 6 % more than with this one.
  /// @tparam kGuess    Whether corners are looked up, or support points.
  /// @tparam kIsCheck  Whether a common point is enough.
  /// @param first      The corner along the ray.
  /// @return false where roundoff leaves no triangle about the ray.
  template <bool kGuess, bool kIsCheck>
  bool DiscoverPortal(const Point& axis, const Corner& first) {
    constexpr S kSpread = S(1.5);
    // Twice and four times as much cost hulls of 241 vertices, ten times as long as thick, 1 and 3 % more.
    constexpr S kNearSq = S(0.5);
    // A hull's point that is farther out by less than so much is left out. By measurement, checks of hulls that touch
    // take 4 % less by that, and of hulls 1 m across that are 5 to 15 cm deep as long.
    constexpr S kWellInside = S(1.2);
    const auto along = [this](const Point& direction) {
      return kGuess ? support_.GuessAlong(direction) : support_.CornerAlong(direction);
    };
    const S height = axis.dot(first.point);
    const Point lateral = first.point - height * axis;
    // The point of skewed sets that is farthest along the ray is far from it, and so is what is found like that.
    if (lateral.squaredNorm() > kNearSq * height * height) return portal_.template RefinePortal<false>(first);
    const Corner second = along(height * axis - kSpread * lateral);
    if (kIsCheck && !wants_corners_ && height * height > kWellInside * kWellInside * portal_.ray.squaredNorm() &&
        FindCommonPoint(axis, first, second)) {
      return true;
    }
    const Point across = axis.cross(second.point - first.point);
    const S width_sq = across.squaredNorm(), side = across.dot(first.point);
    if (!portal_.template RefinePortal<false>(first) || !portal_.template RefinePortal<false>(second)) return false;
    if (!(width_sq > kEpsilon<S> * height * height)) return true;
    // Half the line's length at least, where that nearly meets the ray.
    const S tilt = kSpread * std::max(std::abs(side) / width_sq, S(0.5));
    return portal_.template RefinePortal<false>(along(height * axis - std::copysign(tilt, side) * across));
  }

  /// Finds a common point in the hull of the ball about the centre and of the point between two corners that is nearest
  /// to the ray.
  bool FindCommonPoint(const Point& axis, const Corner& a, const Corner& b) {
    const S height = axis.dot(a.point);
    const Point between = b.point - a.point;
    const Point lateral = a.point - height * axis, step = between - axis.dot(between) * axis;
    const S step_sq = step.squaredNorm();
    const S part = step_sq > 0 ? std::clamp(-lateral.dot(step) / step_sq, S(0), S(1)) : S(0);
    const S inradius_1 = support_.Inradius1(), inradius = inradius_1 + support_.Inradius2();
    const auto end = FindInBallHull<S, 3>(portal_.ray, a.point + part * between, inradius);
    if (!end || !support_.HasInterior(a)) return false;
    const Point of_corners = (1 - part) * support_.FromCenter1(a.feature_1) + part * support_.FromCenter1(b.feature_1);
    common_ = support_.pose_1.rotation * support_.set_1.core.Center() + end->share * of_corners +
              inradius_1 / inradius * end->inside;
    return true;
  }

  Portal<S>& portal_;
  Support& support_;
  std::optional<Corner> first_;  // Farthest corner along the ray, if it is known.
  std::optional<Point> common_;
  bool wants_corners_ = true;
};

}  // namespace dgd::solver_internal
