// The simplex of GJK: the point, side or triangle of a few points of a convex set that is nearest to the origin.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// Convex weight of b in the point of the side from a to b nearest to the origin; the side may be a point.
template <class S>
S WeightOfSecond(const Vector3<S>& a, const Vector3<S>& b) {
  const Vector3<S> side = b - a;
  const S length_sq = side.squaredNorm();
  return length_sq > 0 ? std::clamp(-side.dot(a) / length_sq, S(0), S(1)) : S(0);
}

/// Takes out what roundoff leaves of the cross product of two sides of a thin triangle along the longer one: it would
/// tilt the plane by the side's length.
template <class S>
DGD_NOINLINE void Straighten(Vector3<S>& cross, const Vector3<S>& a, const Vector3<S>& b) {
  const Vector3<S>& longer = a.squaredNorm() > b.squaredNorm() ? a : b;
  const S length_sq = longer.squaredNorm();
  if (length_sq > 0) cross -= cross.dot(longer) / length_sq * longer;
}

/// Convex weights of the point of triangle (a, b, c) nearest to the origin; the triangle may be degenerate. On a sliver
/// the inside's weights have lost their digits, and a side may be nearer: there all are tried. Not inlined: it is long,
/// and the same for all sets.
template <class S>
DGD_FLATTEN DGD_NOINLINE std::array<S, 3> WeightsOfNearest(const Vector3<S>& a, const Vector3<S>& b,
                                                           const Vector3<S>& c) {
  const std::array<const Vector3<S>*, 3> corners{&a, &b, &c};
  std::array<S, 3> nearest{};
  S least = std::numeric_limits<S>::infinity();
  const auto take_if_nearer = [&](const std::array<S, 3>& weights) {
    const S distance_sq = (weights[0] * a + weights[1] * b + weights[2] * c).squaredNorm();
    if (!(distance_sq < least)) return;
    least = distance_sq;
    nearest = weights;
  };
  const Vector3<S> normal = (b - a).cross(c - a);
  const std::array<S, 3> parts{normal.dot(b.cross(c)), normal.dot(c.cross(a)), normal.dot(a.cross(b))};
  const S sum = parts[0] + parts[1] + parts[2];
  if (sum > 0 && parts[0] >= 0 && parts[1] >= 0 && parts[2] >= 0) {
    const std::array<S, 3> inside{parts[0] / sum, parts[1] / sum, parts[2] / sum};
    // Twice the area over the longest side's square: the weights lose two digits at most.
    constexpr S kFat = S(0.01);
    const S longest_sq = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
    if (normal.squaredNorm() > kFat * kFat * longest_sq * longest_sq) return inside;
    take_if_nearer(inside);
  }
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    std::array<S, 3> weights{};
    weights[to] = WeightOfSecond<S>(*corners[from], *corners[to]);
    weights[from] = 1 - weights[to];
    take_if_nearer(weights);
  }
  return nearest;
}

/// Up to three points, all of which have a weight in the point of their hull that is nearest to the origin.
template <class S>
class GjkSimplex {
 public:
  using Feature = DifferencePoint<S, 3>;

  GjkSimplex() = default;

  /// The simplex of up to three points.
  GjkSimplex(const std::array<Feature, 3>& points, std::size_t size) : points_(points), size_(size) {
    DGD_ASSERT(size_ <= 3);
    if (size_ > 0) Reduce();
  }

  /// Whether the simplex is a triangle that makes a tetrahedron with `apex` which holds the origin.
  bool HoldsOriginWith(const Vector3<S>& apex) const {
    if (size_ < 3) return false;
    const Vector3<S>&a = points_[0].point, &b = points_[1].point, &c = points_[2].point;
    const auto volume = [](const Vector3<S>& x, const Vector3<S>& y, const Vector3<S>& z) { return x.dot(y.cross(z)); };
    const std::array<S, 4> parts{volume(a, b, c), volume(apex, c, b), volume(apex, a, c), volume(apex, b, a)};
    return std::ranges::all_of(parts, [](S part) { return part > 0; }) ||
           std::ranges::all_of(parts, [](S part) { return part < 0; });
  }

  /// Adds one of three points at most; to be followed by Reduce().
  void Append(const Feature& added) {
    DGD_ASSERT(size_ < 3);
    points_[size_++] = added;
  }
  /// Finds the nearest point, and drops the points without weight.
  void Reduce() { TakeWeights(Weights()); }

  /// Adds a point, and keeps the part of the hull of all that is nearest to the origin, of those that have that point.
  /// @param is_ahead  Whether the point is over the simplex along its normal: then it has a weight, and is kept where
  ///                  roundoff, next to a near origin, leaves none.
  void Add(const Feature& added, bool is_ahead = false) {
    std::array<S, 3> of_nearest{};
    std::size_t place = size_;
    if (size_ < 3) {
      Append(added);
      of_nearest = Weights();
    } else {
      S least = std::numeric_limits<S>::infinity();
      place = 0;
      for (std::size_t left_out = 0; left_out < 3; ++left_out) {
        std::array<const Vector3<S>*, 3> corners{&points_[0].point, &points_[1].point, &points_[2].point};
        corners[left_out] = &added.point;
        const std::array<S, 3> weights = WeightsOfNearest<S>(*corners[0], *corners[1], *corners[2]);
        const S distance_sq =
            (weights[0] * *corners[0] + weights[1] * *corners[1] + weights[2] * *corners[2]).squaredNorm();
        if (!(distance_sq < least)) continue;
        least = distance_sq;
        place = left_out;
        of_nearest = weights;
      }
      points_[place] = added;
    }
    if (is_ahead) of_nearest[place] = std::max(of_nearest[place], std::numeric_limits<S>::min());
    TakeWeights(of_nearest);
  }

  /// Unit vector from the nearest point to the origin, which is not on the simplex: across that, so that it keeps its
  /// digits as the origin comes near.
  Vector3<S> Normal() const {
    if (size_ == 3) {
      Vector3<S> cross = Side(1).cross(Side(2));
      Straighten<S>(cross, Side(1), Side(2));
      return (cross.dot(nearest_) > 0 ? S(-1) : S(1)) * cross.normalized();
    }
    Vector3<S> across = -nearest_;
    if (size_ == 2) across -= across.dot(Side(1)) / Side(1).squaredNorm() * Side(1);
    return across.normalized();
  }
  /// The hull's point nearest to the origin.
  const Vector3<S>& Nearest() const { return nearest_; }
  /// The nearest point with its part of set 1.
  Feature Combination() const {
    Feature sum;
    for (std::size_t i = 0; i < size_; ++i) {
      sum.point += weights_[i] * points_[i].point;
      sum.on_1 += weights_[i] * points_[i].on_1;
    }
    return sum;
  }
  std::size_t Size() const { return size_; }
  /// Convex weight of a point in the nearest one.
  S Weight(std::size_t i) const {
    DGD_ASSERT(i < size_);
    return weights_[i];
  }
  /// @pre i < Size(), or nothing of the point counts but its features as a hint.
  const Feature& operator[](std::size_t i) const {
    DGD_ASSERT(i < points_.size());
    return points_[i];
  }
  /// Leaves the features of the points for another query.
  void Leave(WarmStart<S>& state) const {
    state.size = 0;
    for (std::size_t i = 0; i < size_; ++i) state.Add(points_[i].feature_1, points_[i].feature_2);
  }

 private:
  /// Convex weights of the points in the nearest one.
  std::array<S, 3> Weights() const {
    if (size_ == 3) return WeightsOfNearest<S>(points_[0].point, points_[1].point, points_[2].point);
    const S of_second = size_ == 2 ? WeightOfSecond<S>(points_[0].point, points_[1].point) : S(0);
    return {1 - of_second, of_second};
  }

  /// Finds the nearest point by its weights, and drops the points without one.
  void TakeWeights(const std::array<S, 3>& weights) {
    const std::size_t size = size_;
    size_ = 0;
    nearest_.setZero();
    for (std::size_t i = 0; i < size; ++i) {
      if (!(weights[i] > 0)) continue;
      nearest_ += weights[i] * points_[i].point;
      if (size_ != i) points_[size_] = points_[i];
      weights_[size_++] = weights[i];
    }
  }

  Vector3<S> Side(std::size_t to) const { return points_[to].point - points_[0].point; }

  std::array<Feature, 3> points_;
  std::array<S, 3> weights_{};
  std::size_t size_ = 0;
  Vector3<S> nearest_ = Vector3<S>::Zero();
};

/// Whether a search that goes from simplex to simplex gets on. A normal that is off by the root of a roundoff makes no
/// difference to the length, and one to the planes: so, a few times, as near as before is enough, within the roundoff
/// of the points.
template <class S>
class Descent {
 public:
  /// @param before, after  Length of the nearest point, metres.
  /// @param roundoff       Of the simplex's points, metres.
  bool Continues(S before, S after, S roundoff) {
    if (after < before) return true;
    return after <= before + roundoff && sideways_++ < kMaxSideways;
  }

 private:
  /// Of four searches in float that stalled 1e-4 m off, in 24 seeds of the test of UpdateDistance(), one such step
  /// freed all.
  static constexpr int kMaxSideways = 3;

  int sideways_ = 0;
};

}  // namespace dgd
