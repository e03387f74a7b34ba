// The support points of a query, of each set alone.
//
// Any point of set 1 less any point of set 2 belongs to C: k evaluations of the support functions give not k points of
// C but k^2. In the dual, the support function of C is the sum of the sets' (eq. 5), and models of each term approach
// the minimum in fewer steps than a model of the sum: these are the disaggregated cutting planes of the multicut method
// (Birge and Louveaux 1988, "A multicut algorithm for two-stage stochastic linear programs"). The latest few are kept.
//
// Measured: custom sets of hulls take a third fewer directions by it, sharp ones 6 % fewer instructions; smooth custom
// sets, whose points are met once, up to 2.3 times the instructions. It is kept for how exact the last normal is:
// without it, bodies of unequal spheres and of apps' own shapes that lie on boxes creep (tests/physics, rest and
// incline).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "dgd/assert.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd {

template <class S, int L = 3>
class SupportPool {
 public:
  using Point = Vector<S, L>;

  /// Number of points that are kept, beyond which the oldest is forgotten: four cost meshes 5 % more directions, twelve
  /// save 1 %.
  static constexpr std::size_t kCapacity = 8;

  /// @param support  Of C; its parts from the two sets are what is remembered.
  void Remember(const DifferencePoint<S, L>& support) {
    on_1_[next_] = {support.on_1, support.feature_1};
    minus_2_[next_] = {support.point - support.on_1, support.feature_2};
    next_ = (next_ + 1) % kCapacity;
    if (size_ < kCapacity) ++size_;
  }

  /// The point of C farthest along a direction, of all differences of known points. At least one is known.
  DifferencePoint<S, L> Farthest(const Point& direction) const {
    DGD_ASSERT(size_ > 0);
    const SupportPoint<S, L>& a = Farthest(on_1_, direction);
    const SupportPoint<S, L>& b = Farthest(minus_2_, direction);
    return {a.point + b.point, a.point, a.feature, b.feature};
  }

 private:
  using Points = std::array<SupportPoint<S, L>, kCapacity>;

  const SupportPoint<S, L>& Farthest(const Points& points, const Point& direction) const {
    std::size_t farthest = 0;
    S height = direction.dot(points[0].point);
    for (std::size_t i = 1; i < size_; ++i) {
      const S other = direction.dot(points[i].point);
      // There is no branch: which one is higher cannot be predicted.
      farthest = other > height ? i : farthest;
      height = std::max(height, other);
    }
    return points[farthest];
  }

  Points on_1_, minus_2_;  // Ray frame, about the centres; minus_2_ the negative of set 2's.
  std::size_t next_ = 0, size_ = 0;
};

}  // namespace dgd
