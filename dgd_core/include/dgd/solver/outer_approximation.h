// The outer approximation: the one supporting plane of C that meets the ray lowest (paper, Sec. III-C1).
#pragma once

#include <limits>

#include "dgd/assert.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

template <class S, int L = 3>
class OuterApproximation {
 public:
  using Point = Vector<S, L>;

  /// Takes the supporting plane <normal, z> <= support_value, which touches C above `support`, if it bounds the ray
  /// better than all before. Eq. (outer-approximation-update): the bound is v / <lambda, p>, here the plane's height.
  /// @param normal  Ray frame, unit length, normal[L - 1] > 0.
  void Cut(const Point& normal, S support_value, const DifferencePoint<S, L>& support) {
    DGD_ASSERT(IsUnitOrNan(normal) && !(normal[L - 1] <= 0));
    const S height = support_value / normal[L - 1];
    // False for NaN, which then leaves the bounds as they are.
    if (height < height_) {
      height_ = height;
      normal_ = normal;
      support_value_ = support_value;
      on_1_ = support.on_1;
    }
  }

  /// Takes the plane whatever it says of the ray: of use where there is no ray, see RayIntersection.
  void Adopt(const Point& normal, S support_value, const DifferencePoint<S, L>& support) {
    DGD_ASSERT(IsUnitOrNan(normal));
    height_ = support_value;
    normal_ = normal;
    support_value_ = support_value;
    on_1_ = support.on_1;
  }

  /// Upper bound on the height at which the ray leaves C, metres; infinite before the first cut.
  S Height() const { return height_; }
  /// Unit normal of the best plane, ray frame.
  const Point& Normal() const { return normal_; }
  /// Support value of C along that normal, metres.
  S SupportValue() const { return support_value_; }
  /// Support point of set 1's core along that normal, ray frame about its centre, metres.
  const Point& SupportPoint1() const { return on_1_; }

 private:
  S height_ = std::numeric_limits<S>::infinity();
  Point normal_ = Point::Unit(L - 1);
  S support_value_ = std::numeric_limits<S>::infinity();
  Point on_1_ = Point::Zero();
};

}  // namespace dgd
