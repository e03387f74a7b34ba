// Flat discs on curved cores: the caps of cylinders, the base of cones.
//
// A rim's support function r |d_xy| has a kink along the axis, and where the ray leaves C through the cap, that kink is
// the optimum: Newton's step never gets there, and cutting planes creep along the rim. But both the normal and the
// points are known at once: the plane of C along the disc's normal touches it in the disc and a point of the other set,
// or a disc of that one, too.
#pragma once

#include <cmath>

#include "dgd/ray/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd {

/// Whether the ray leaves C within a disc of one set's, moved by the other set's support point along its normal.
/// @param support     Along the normal of one of the discs of its features: `is_of_1` says of which set.
/// @param height      Of the plane of C there, on the ray, metres.
/// @param on_1        Out: the point of set 1 that the ray's point comes from.
template <class Difference>
bool LeavesByDisc(const Difference& difference, const typename Difference::Feature& support, bool is_of_1,
                  typename Difference::S height, typename Difference::Point& on_1) {
  using S = typename Difference::S;
  using Point = typename Difference::Point;
  FlatDisc<S> disc_1 = difference.Face1(support.feature_1), disc_2 = difference.Face2(support.feature_2);
  const Point normal = is_of_1 ? disc_1.normal : disc_2.normal;
  const Point on_ray = height * Point::UnitZ();
  // What there is of the other set: where its disc lies the same way, that; else the point.
  constexpr S kSameWay = 4 * kEpsilon<S>;
  if (!(disc_1.normal.cross(disc_2.normal).norm() <= kSameWay && disc_1.normal.dot(disc_2.normal) > 0)) {
    if (is_of_1) {
      disc_2 = {normal, support.point - support.on_1 - difference.Radius2() * normal, 0};
    } else {
      disc_1 = {normal, support.on_1 - difference.Radius1() * normal, 0};
    }
  }
  const Point center_1 = disc_1.center + difference.Radius1() * normal;
  const Point center_2 = disc_2.center + difference.Radius2() * normal;
  const Point from_center = on_ray - center_1 - center_2;
  const S radius = disc_1.radius + disc_2.radius;
  if (!(radius > 0 && from_center.norm() <= radius)) return false;
  on_1 = center_1 + disc_1.radius / radius * from_center;
  return true;
}

}  // namespace dgd
