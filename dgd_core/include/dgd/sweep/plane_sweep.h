// How long a plane keeps two moving sets apart: proven for every moment between two, not only at them.
//
// Along a fixed normal n, a set reaches to <n, c(t)> + h(d(t)): c is the point that it turns about, which moves
// straight, h the support function of its core about that point, and d(t) = R(t)' n the normal as the turning set sees
// it. d moves on an arc: its part across the axis, of length s, turns by an angle a between two moments. Shortened by
// at most 1 - cos(a / 2) <= a^2 / 8 of its length, that part lies on the chord, so that for some x in [0, 1]
//
//     d = x d0 + (1 - x) d1 + r d_across,    0 <= r <= a^2 / 8.
//
// h is sublinear, and no point of the core is farther from the axis than rho, so that
//
//     h(d) <= x h(d0) + (1 - x) h(d1) + a^2 / 8 s rho.
//
// x falls from 1 to 0 almost evenly: while a is at most a right angle it is never off by more than a^2 / 50. So the
// separation of two sets lies above its own chord in time, but for a^2 (s rho / 8 + |h(d0) - h(d1)| / 50) of either. A
// set that does not turn, or whose core is the point that it turns about, has no such term.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/motion.h"

namespace dgd {

/// One of the two sets, as it moves.
template <class Set>
class MovingSet {
 public:
  using S = typename Set::Scalar;
  using Point = Vector3<S>;

  MovingSet(const Set& set, const Motion<S>& motion) : set_(set), motion_(motion), angle_(motion.rotation.norm()) {
    if (!(angle_ > 0)) return;
    axis_ = motion.rotation / angle_;
    // Two extents across the axis bound the distance of the core's points from it.
    const auto widest = [&](const Point& direction) {
      return std::max(ExtentAtStart(direction), ExtentAtStart(-direction));
    };
    const Point across = axis_.unitOrthogonal();
    reach_ = std::hypot(widest(across), widest(axis_.cross(across)));
  }

  /// How far the core reaches along a unit vector from the point that the set turns about.
  S Extent(const Point& normal, S time) const {
    const S angle = -time * angle_;
    if (!(angle < 0)) return ExtentAtStart(normal);
    // Turned back, by Rodrigues' formula.
    const S cosine = std::cos(angle);
    return ExtentAtStart(cosine * normal + std::sin(angle) * axis_.cross(normal) +
                         (1 - cosine) * axis_.dot(normal) * axis_);
  }

  /// Most by which the extent may exceed its chord between two moments, which are `duration` apart. Infinite if the set
  /// turns by more than a right angle between them.
  S Bulge(const Point& normal, S duration, S extent_0, S extent_1) const {
    const S angle = duration * angle_;
    if (!(angle > 0)) return 0;
    if (angle > std::numbers::pi_v<S> / 2) return std::numeric_limits<S>::infinity();
    const S across = normal.cross(axis_).norm();
    return angle * angle * (across * reach_ / 8 + std::abs(extent_1 - extent_0) / 50);
  }

 private:
  S ExtentAtStart(const Point& normal) const {
    const Point direction = motion_.start.rotation.transpose() * normal;
    return direction.dot(set_.core.Support(direction).point - motion_.center);
  }

  const Set& set_;
  const Motion<S>& motion_;
  Point axis_ = Point::UnitX();
  S angle_;
  S reach_ = 0;
};

/// Two moving sets, and the planes that keep them apart. Refers to the sets and their motions.
template <class Set1, class Set2>
class PlaneSweep {
 public:
  using S = typename Set1::Scalar;
  using Point = Vector3<S>;

  /// @param allowed_overlap  What every separation here is larger by than that of the sets; metres.
  PlaneSweep(const Set1& set_1, const Motion<S>& motion_1, const Set2& set_2, const Motion<S>& motion_2,
             S allowed_overlap = 0)
      : set_1_(set_1, motion_1),
        set_2_(set_2, motion_2),
        radius_(set_1.radius + set_2.radius - allowed_overlap),
        start_(motion_2.CenterAt(0) - motion_1.CenterAt(0)),
        translation_(motion_2.translation - motion_1.translation) {}

  /// The last time up to which a plane that separates the sets at `time` is proven to go on doing so.
  /// @param normal   Its unit normal from set 1 to set 2, world.
  /// @param nearest  Metres, > 0: the search ends where the separation falls to this.
  S KeepsApartUntil(const Point& normal, S time, S nearest) {
    DGD_ASSERT(time >= 0 && time <= 1 && nearest > 0);
    Moment from = At(normal, time);
    Moment to = At(normal, 1);
    S latest = 1;          // The earliest time at which the separation is known to be too small, or the end.
    S longest = 1 - time;  // What the last bulge that was too large lets an interval be.
    // Aimed for: within the interval [nearest / 2, nearest] that ends the search.
    const S goal = S(0.75) * nearest;
    // The weight of the separation at `from` is halved while chords cross the goal too late (the Illinois variant of
    // regula falsi).
    S weight = 1;
    for (int i = 0; i < kMaxCuts && from.separation > nearest; ++i) {
      const S duration = to.time - from.time;
      const S bulge = set_1_.Bulge(normal, duration, from.extent_1, to.extent_1) +
                      set_2_.Bulge(normal, duration, from.extent_2, to.extent_2);
      const S least = std::min(from.separation, to.separation);
      S next = latest;
      if (to.separation < nearest / 2) {
        latest = to.time;
        const S above = weight * (from.separation - goal);
        next = from.time + duration * above / (above + goal - to.separation);
        weight /= 2;
      } else if (least > bulge) {
        const S slope = (to.separation - from.separation) / duration;
        from = to;
        if (from.time >= 1) break;
        if (slope < 0) next = from.time - (from.separation - goal) / slope;
        weight = 1;
      } else {
        // The bulge goes with the square of the duration, nearly: nine tenths of what would do, by that.
        longest = duration * std::clamp(S(0.9) * std::sqrt(least / bulge), S(0.1), S(0.7));
      }
      next = std::min({next, from.time + longest, latest});
      if (!(next > from.time)) break;
      to = At(normal, next);
    }
    return from.time;
  }

  S SeparationAt(const Point& normal, S time) { return At(normal, time).separation; }

  int Evaluations() const { return evaluations_; }

 private:
  struct Moment {
    S time, extent_1, extent_2, separation;
  };

  /// A plane that needs more is given up for the one that fits where it has got to.
  static constexpr int kMaxCuts = 30;

  Moment At(const Point& normal, S time) {
    ++evaluations_;
    Moment moment{time, set_1_.Extent(normal, time), set_2_.Extent(-normal, time), 0};
    // The separation comes from the difference of the centres, so that both may be far from the world's origin.
    moment.separation = normal.dot(start_ + time * translation_) - moment.extent_1 - moment.extent_2 - radius_;
    return moment;
  }

  MovingSet<Set1> set_1_;
  MovingSet<Set2> set_2_;
  S radius_;                   // Sum of both radii, less the allowed overlap.
  Point start_, translation_;  // Motion of set 2's centre from set 1's.
  int evaluations_ = 0;
};

}  // namespace dgd
