// The inner approximation: the feature of conv(support points) + ball through which the ray leaves it.
//
// The paper (Sec. III-C2) keeps a basis of three points of C whose triangle the ray crosses, and replaces one of them
// by the new support point with a step of the simplex method. We depart from it where the sets have a radius R:
//
// C = K + ball(R), K the difference of the cores. For any points S of K, conv(S) + ball(R) lies in C, so the height at
// which the ray leaves it is a lower bound on the ray intersection. It leaves it on the offset of one feature of
// conv(S): a vertex (a ball of radius R), an edge (a cylinder) or a triangle (a plane), each in closed form
// (feature_exit.h). The normal there is the next direction to search.
//
// In the plane the facets are segments instead of triangles, the rest is the same.
//
// All coordinates are in the ray frame: the last one is the height along the ray, those before run across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/solver/feature_exit.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/simplex_step.h"
#include "dgd/solver/tolerances.h"
#include "dgd/solver/triangle_crossing.h"

namespace dgd {

namespace solver_internal {
/// Sine of 120 degrees; the cosine is -1/2.
template <class S>
inline constexpr S kSineOfThirdTurn = S(0.86602540378443865);

/// Where the ray leaves a feature that takes the basis's place.
template <class S, int L>
struct NextBasis : FeatureExit<S, L> {
  std::array<int, L - 1> kept{};  // The basis points that the feature has; the added point comes last.
};
}  // namespace solver_internal

/// The basis: the points of the feature through which the ray leaves, and their weights. InnerUpdate adds points to it.
template <class S, int L = 3>
class InnerApproximation {
 public:
  using Point = Vector<S, L>;
  using Candidate = solver_internal::NextBasis<S, L>;

  /// Starts at the difference of the centres, which belongs to the cores' difference: for convex_radius > 0.
  static InnerApproximation FromCenter(S convex_radius) {
    DGD_ASSERT(!(convex_radius < 0));
    InnerApproximation approximation;
    approximation.convex_radius_ = convex_radius;
    approximation.size_ = 1;
    approximation.weights_ = {1};
    approximation.height_ = convex_radius;
    return approximation;
  }

  /// Starts with a facet in a ball of `inradius` inside the cores' difference (paper, eq.
  /// inner-approximation-initialization). Set 1 contributes `share_1` of each point. With a radius, `convex_radius`,
  /// this takes hulls 6 % fewer directions than the centre does: a facet is there from the first step on.
  static InnerApproximation FromInradius(S inradius, S share_1, S convex_radius = 0) {
    DGD_ASSERT(!(inradius < 0) && !(convex_radius < 0));
    // The ray crosses the facet's middle half way up the ball, and its corners are on the ball.
    constexpr S kSine = solver_internal::kSineOfThirdTurn<S>;
    const S height = inradius / 2;
    const S lateral = kSine * inradius;
    InnerApproximation approximation;
    approximation.size_ = L;
    const auto corner = [&](S cosine, S sine) {
      Point point;
      point[0] = lateral * cosine;
      if constexpr (L == 3) point[1] = lateral * sine;
      point[L - 1] = height;
      return DifferencePoint<S, L>{point, share_1 * point};
    };
    if constexpr (L == 3) {
      approximation.points_ = {corner(1, 0), corner(S(-0.5), kSine), corner(S(-0.5), -kSine)};
    } else {
      approximation.points_ = {corner(1, 0), corner(-1, 0)};
    }
    approximation.weights_.fill(S(1) / L);
    approximation.convex_radius_ = convex_radius;
    approximation.height_ = height + convex_radius;
    return approximation;
  }

  /// Moves the weights of a query's last basis to where their point is nearest to the exit. Where the ray meets an
  /// edge, the basis turns about that from steep facets to flatter ones, and the height that the steepest one gave
  /// stays: at a slope of 0.01 a roundoff error across the ray is a hundred of it in the height. The point is then that
  /// much below the exit, but not that far from the plane. Test: InnerApproximation.MoveToExit_*.
  void MoveToExit() {
    if (weights_inexact_) MoveRoughToExit();
  }

  /// Lower bound on the height at which the ray leaves C, metres.
  S Height() const { return height_; }
  /// Outward unit normal of the approximation where the ray leaves it; its height is > 0 but for roundoff.
  const Point& Normal() const { return normal_; }
  /// The normal's, of any length: a search for a vertex need not wait for the square root.
  const Point& Direction() const { return direction_; }
  /// Points of the feature, Size() of them, counterclockwise about the ray if three.
  const DifferencePoint<S, L>& operator[](int i) const {
    DGD_ASSERT(i >= 0 && i < size_);
    return points_[static_cast<std::size_t>(i)];
  }
  int Size() const { return size_; }
  /// Convex weights of those points, whose combination is the feature's point under the exit.
  S Weight(int i) const {
    DGD_ASSERT(i >= 0 && i < size_);
    return weights_[static_cast<std::size_t>(i)];
  }

  const Point& PointOf(int i) const { return points_[static_cast<std::size_t>(i)].point; }
  S ConvexRadius() const { return convex_radius_; }
  /// Largest coordinate of the basis and the added point, metres.
  S Reach(const Point& added) const {
    S reach = added.cwiseAbs().maxCoeff();
    for (const DifferencePoint<S, L>& point : points_) reach = std::max(reach, point.point.cwiseAbs().maxCoeff());
    return reach;
  }

  /// The cores' points whose difference is the feature's point under the exit: convex combinations (eq.
  /// primal-optimal).
  Point CorePoint1() const {
    return Combine([](const DifferencePoint<S, L>& point) { return point.on_1; });
  }
  Point CorePoint2() const {
    return Combine([](const DifferencePoint<S, L>& point) -> Point { return point.on_1 - point.point; });
  }

  /// Whether a point is farther out than the feature by enough to raise the height by `rise` metres at least, if the
  /// feature were all there is.
  bool IsAbove(const Point& point, S rise) const {
    return direction_.dot(point - PointOf(0)) > rise * direction_[L - 1];
  }

  /// Whether a point adds enough of what is left up to `ceiling` to be worth the insertion; of those met before, most
  /// often it is in the basis already. With a tenth, moving meshes take a tenth more directions.
  bool IsWorthwhile(const Point& point, S ceiling) const {
    constexpr S kLeast = S(0.01);
    return IsAbove(point, kLeast * (ceiling - height_));
  }

  /// Makes the kept points and the added one the basis if there is an exit among them, and that is high enough: far
  /// points are rounded by more than any height.
  bool Replace(const Candidate& candidate, const DifferencePoint<S, L>& added, S ceiling) {
    if (candidate.size == 0 || !IsHighEnough(candidate, added.point)) return false;
    // The kept points go to the front; i < j cyclically, so they may have to move in either order.
    const auto kept_count = static_cast<std::size_t>(candidate.size - 1);
    std::array<DifferencePoint<S, L>, L - 1> kept;
    for (std::size_t i = 0; i < kept_count; ++i) kept[i] = points_[static_cast<std::size_t>(candidate.kept[i])];
    for (std::size_t i = 0; i < kept_count; ++i) points_[i] = kept[i];
    points_[kept_count] = added;
    Adopt(candidate, ceiling);
    return true;
  }

  /// The same as Replace(), for a facet of FacetExit(): the added point takes the dropped one's place, and the kept
  /// ones stay, which puts the three in the same order about the ray.
  bool ReplaceOne(const Candidate& candidate, int dropped, const DifferencePoint<S, L>& added, S ceiling) {
    if (!IsHighEnough(candidate, added.point)) return false;
    points_[static_cast<std::size_t>(dropped)] = added;
    AdoptExit(candidate, ceiling);
    weights_[static_cast<std::size_t>(dropped)] = candidate.weights[L - 1];
    for (std::size_t i = 0; i + 1 < L; ++i)
      weights_[static_cast<std::size_t>(candidate.kept[i])] = candidate.weights[i];
    OrderAboutRay();
    return true;
  }

  /// The same for a step that is certain.
  template <bool kHasRadius>
  void Replace(const solver_internal::SimplexStep<S, kHasRadius>& step, const DifferencePoint<S, L>& added, S ceiling) {
    points_[step.outgoing] = added;
    weights_[step.outgoing] = step.weights[0];
    weights_[step.next] = step.weights[1];
    weights_[step.last] = step.weights[2];
    direction_ = step.direction;
    normal_ = step.normal;
    AdoptHeight(step.height, false, ceiling);
  }

  /// Takes other points for the basis, through whose feature the ray leaves.
  void Adopt(const std::array<DifferencePoint<S, L>, L>& basis, const Candidate& candidate) {
    points_ = basis;
    Adopt(candidate, candidate.height);
  }

 private:
  template <class Part>
  Point Combine(Part part) const {
    Point sum = weights_[0] * part(points_[0]);
    for (std::size_t i = 1; i < static_cast<std::size_t>(size_); ++i) sum += weights_[i] * part(points_[i]);
    return sum;
  }

  /// Offset of the feature's point, moved by the ball, from the exit at the height; metres.
  Point OffExit(const std::array<S, L>& weights) const {
    Point sum = convex_radius_ * normal_ - height_ * Point::Unit(L - 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) sum += weights[i] * points_[i].point;
    return sum;
  }

  DGD_COLD void MoveRoughToExit() {
    std::array<S, L> weights = weights_;
    if (size_ == 2) {
      solver_internal::MoveAlongSide<S, L>(PointOf(1) - PointOf(0), OffExit(weights), weights[0], weights[1]);
    } else if constexpr (L == 3) {
      if (size_ == 1) return;
      const std::array<Point, 3> corners = {PointOf(0), PointOf(1), PointOf(2)};
      const Point target = height_ * Point::UnitZ() - convex_radius_ * normal_;
      solver_internal::MoveFromLongestSide<S, 3>(corners, target, weights);
      solver_internal::MoveAlongSides<S, 3>(corners, target, weights);
    }
    if (OffExit(weights).squaredNorm() < OffExit(weights_).squaredNorm()) weights_ = weights;
  }

  /// Whether the exit is not lower than now by more than roundoff; the bound itself is monotone. Equal heights are
  /// taken: where the ray meets an edge of the basis, a simplex step turns the plane without raising it, and may lower
  /// it by roundoff many times on the way to the right plane.
  bool IsHighEnough(const Candidate& candidate, const Point& added) const {
    return candidate.height >= height_ || candidate.height >= height_ - HeightRoundoff(candidate, added);
  }

  /// Takes over the exit of the points that are now the basis.
  void Adopt(const Candidate& candidate, S ceiling) {
    AdoptExit(candidate, ceiling);
    weights_ = candidate.weights;
    OrderAboutRay();
  }

  void AdoptExit(const Candidate& candidate, S ceiling) {
    size_ = candidate.size;
    normal_ = candidate.normal;
    DGD_ASSERT(size_ >= 1 && size_ <= L && IsUnitOrNan(normal_));
    direction_ = candidate.direction;
    AdoptHeight(candidate.height, candidate.is_rough, ceiling);
  }

  void AdoptHeight(S height, bool is_rough, S ceiling) {
    DGD_ASSERT(!std::isnan(height));
    height_ = std::max(height_, std::min(height, ceiling));
    weights_inexact_ = is_rough || height_ != height;
  }

  /// Counterclockwise, which OutgoingIndex() relies on.
  void OrderAboutRay() {
    if constexpr (L == 3) {
      if (size_ == 3 && solver_internal::Cross<S>(PointOf(1) - PointOf(0), PointOf(2) - PointOf(0)) < 0) {
        std::swap(points_[0], points_[1]);
        std::swap(weights_[0], weights_[1]);
      }
    }
  }

  /// How much lower than now an exit may be by roundoff: the error of the points' coordinates across the ray, up the
  /// slope of the steeper plane.
  S HeightRoundoff(const Candidate& candidate, const Point& added) const {
    return kWeightSlack<S> * Reach(added) / std::max(kSteep<S>, std::min(candidate.normal[L - 1], normal_[L - 1]));
  }

  std::array<DifferencePoint<S, L>, L> points_;
  std::array<S, L> weights_{};
  Point normal_ = Point::Unit(L - 1);
  Point direction_ = Point::Unit(L - 1);
  S convex_radius_ = 0;
  S height_ = 0;
  int size_ = 0;
  bool weights_inexact_ = false;  // The weights' point may not be the exit.
};

}  // namespace dgd
