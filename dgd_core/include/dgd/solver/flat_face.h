// Flat discs on curved cores: the caps of cylinders, the base of cones.
//
// A rim's support function r |d_xy| has a kink along the axis, and where the ray leaves C through the cap, that kink is
// the optimum: Newton's step never gets there, and cutting planes creep along the rim. But both the normal and the
// points are known at once: the plane of C along the disc's normal touches it in the disc and a point of the other set,
// or a disc of that one, too.
#pragma once

#include "dgd/assert.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// Whether the ray leaves C through a disc of either set, or of both.
/// @param support  Of C along the normal.
/// @param normal   Of a disc, ray frame, unit length.
/// @param height   Of C's supporting plane there, on the ray, metres.
/// @param on_1     Out: the point of set 1 that the ray's point comes from; ray frame, about its centre.
template <class Difference>
bool LeavesByDisc(const Difference& difference, const typename Difference::Feature& support,
                  const typename Difference::Point& normal, typename Difference::S height,
                  typename Difference::Point& on_1) {
  using S = typename Difference::S;
  using Point = typename Difference::Point;
  DGD_ASSERT(IsUnitOrNan(normal));
  // What touches the plane, of each set: a disc, or the support point alone.
  const auto touching = [&normal](FlatDisc<S> disc, const Point& point, S radius) {
    constexpr S kSameWay = 4 * kEpsilon<S>;
    const bool is_disc = disc.normal.dot(normal) > 0 && disc.normal.cross(normal).norm() <= kSameWay;
    if (!is_disc) return FlatDisc<S>{normal, point, 0};
    disc.center += radius * normal;
    return disc;
  };
  const FlatDisc<S> disc_1 = touching(difference.Face1(support.feature_1), support.on_1, difference.Radius1());
  const FlatDisc<S> disc_2 =
      touching(difference.Face2(support.feature_2), support.point - support.on_1, difference.Radius2());
  const Point from_center = height * Point::UnitZ() - disc_1.center - disc_2.center;
  const S radius = disc_1.radius + disc_2.radius;
  if (!(radius > 0 && from_center.norm() <= radius)) return false;
  on_1 = disc_1.center + disc_1.radius / radius * from_center;
  return true;
}

}  // namespace dgd
