// The inner approximation: the feature of conv(support points) + ball through which the ray leaves it.
//
// The paper (Sec. III-C2) keeps a basis of three points of C whose triangle the ray crosses, and replaces one of them
// by the new support point with a step of the simplex method. We depart from it where the sets have a radius R:
//
//   Rounded inner approximation. C = K + ball(R), K the difference of the cores. For any points S of K, conv(S) +
//   ball(R) lies in C, so the height at which the ray leaves it is a lower bound on the ray intersection. The ray
//   leaves it on the offset of exactly one feature of conv(S): a vertex (a ball of radius R), an edge (a cylinder) or a
//   triangle (a plane), and the normal there is the next direction to search. Each has a closed form: feature_exit.h.
//
//   Update. Let h be the old height, reached on a feature F with normal n, and w the support point of K along n. If
//   <n, w> exceeds the value on F, the old exit point is interior to conv(F, w) + ball(R), so the ray now leaves it
//   higher, and through a feature that has w among its vertices: one without w belongs to conv(F) and cannot be higher
//   than h. The new basis is therefore the highest of the features of conv(F, w) that contain w and that the ray
//   crosses (at most three triangles, three edges and w itself). Otherwise F is optimal.
//
//   Termination. Heights rise strictly and K of a polytope pair has finitely many vertices, so rounded polytopes end
//   after finitely many steps, as sharp ones do; with the ball in the support function they only converge in the limit.
//
// Without a radius only triangles can carry the ray, and the update is the paper's simplex step: the plane is divided
// by the rays from the origin through the three projected points, and -w lies in one of the three wedges; the two
// points that span it stay. That is the ratio test (eq. outgoing index) in barycentric coordinates of the projected
// points.
//
// In the plane the facets are segments instead of triangles, the rest is the same.
//
// All coordinates are in the ray frame: the last one is the height along the ray, those before run across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/ray/feature_exit.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/simplex_step.h"
#include "dgd/ray/tolerances.h"

namespace dgd {

namespace ray_internal {
/// Of 120 degrees; the cosine is -1/2.
template <class S>
inline constexpr S kSineOfThirdTurn = S(0.86602540378443865);
}  // namespace ray_internal

template <class S, int L = 3>
class InnerApproximation {
 public:
  using Point = Vector<S, L>;

  /// Starts at the difference of the centres, which belongs to the cores' difference: for rounding > 0.
  static InnerApproximation FromCenter(S rounding) {
    DGD_ASSERT(rounding > 0);
    InnerApproximation approximation;
    approximation.rounding_ = rounding;
    approximation.size_ = 1;
    approximation.weights_ = {1};
    approximation.height_ = rounding;
    return approximation;
  }

  /// Starts with a facet in a ball of `inradius` inside the cores' difference (paper, eq.
  /// inner-approximation-initialization). Set 1 contributes `share_1` of each point. With a radius, `rounding`,
  /// this takes hulls 6 % fewer directions than the centre does: a facet is there from the first step on.
  static InnerApproximation FromInradius(S inradius, S share_1, S rounding = 0) {
    DGD_ASSERT(!(inradius < 0) && !(rounding < 0));
    // The ray crosses the facet's middle half way up the ball, and its corners are on the ball.
    constexpr S kSine = ray_internal::kSineOfThirdTurn<S>;
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
    approximation.rounding_ = rounding;
    approximation.height_ = height + rounding;
    return approximation;
  }

  /// Adds a point of the cores' difference and keeps the feature through which the ray now leaves.
  /// @param ceiling  A height that C does not reach beyond. A feature that does, by more than rounding, has lost its
  ///                 digits and is not taken.
  /// @return whether the approximation changed; its height never falls. False also where rounding leaves no feature.
  bool Insert(const DifferencePoint<S, L>& added, S ceiling = std::numeric_limits<S>::infinity()) {
    ceiling_ = ceiling;
    DGD_ASSERT(size_ >= 1 && size_ <= L);
    return rounding_ > 0 ? InsertRounded(added) : InsertSharp(added);
  }

  /// Whether a point is farther out than the feature.
  bool IsAbove(const Point& point) const { return direction_.dot(point - PointOf(0)) > 0; }

  /// Takes over a whole basis, one to L points of the cores' difference that were the feature of an earlier query,
  /// if the ray leaves through the same feature, not lower than so far.
  bool AdoptBasis(const std::array<DifferencePoint<S, L>, L>& basis, int size) {
    if (size < 1 || (rounding_ == 0 && size < L)) return false;
    Candidate candidate;
    if (!BasisExit(basis, size, candidate) || !(candidate.height >= height_)) return false;
    points_ = basis;
    Adopt(candidate);
    return true;
  }

  /// For the last basis of a query: moves the weights to where their point is nearest to the exit. Where the ray meets
  /// an edge, the basis turns about that from steep facets to flatter ones, and the height that the steepest one gave
  /// stays: at a slope of 0.01 a rounding error across the ray is a hundred of it in the height. The point is then that
  /// much below the exit, but not that far from the plane. Test: InnerApproximation.MoveToExit_*.
  void MoveToExit() {
    if (is_rough_) MoveRoughToExit();
  }

  /// Lower bound on the height at which the ray leaves C, metres.
  S Height() const { return height_; }
  /// Outward unit normal of the approximation where the ray leaves it; its height is > 0 but for rounding.
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

  /// The cores' points whose difference is the feature's point under the exit: convex combinations (eq.
  /// primal-optimal).
  Point CorePoint1() const {
    return Combine([](const DifferencePoint<S, L>& point) { return point.on_1; });
  }
  Point CorePoint2() const {
    return Combine([](const DifferencePoint<S, L>& point) -> Point { return point.on_1 - point.point; });
  }

 private:
  struct Candidate : ray_internal::FeatureExit<S, L> {
    std::array<int, L - 1> kept{};  // Which basis points its feature has; the added point comes last.
  };

  /// The best facet so far of those that the ray may cross, without a radius.
  struct SharpChoice {
    Candidate best;
    bool best_is_outside = false;

    /// @return whether the candidate is as good as any other can be.
    bool Take(const Candidate& candidate, bool is_outside) {
      const S slope = candidate.normal[L - 1];
      const bool is_better = is_outside != best_is_outside ? is_outside
                             : is_outside                  ? slope > best.normal[L - 1]
                                                           : candidate.height > best.height;
      if (best.size == 0 || is_better) {
        best = candidate;
        best_is_outside = is_outside;
      }
      return is_outside && slope > kSteep<S>;
    }
  };

  /// Steep features magnify the rounding of their points to heights that are off by less than this part.
  static constexpr S kCeilingSlack = sizeof(S) == 8 ? 4 * kSqrtEpsilon<S> : kSqrtEpsilon<S> / 16;

  template <class Part>
  Point Combine(Part part) const {
    Point sum = weights_[0] * part(points_[0]);
    for (std::size_t i = 1; i < static_cast<std::size_t>(size_); ++i) sum += weights_[i] * part(points_[i]);
    return sum;
  }

  const Point& PointOf(int i) const { return points_[static_cast<std::size_t>(i)].point; }

  /// Of the feature's point, moved by the ball, from the exit at the height, metres.
  Point OffExit(const std::array<S, L>& weights) const {
    Point sum = rounding_ * normal_ - height_ * Point::Unit(L - 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) sum += weights[i] * points_[i].point;
    return sum;
  }

  DGD_COLD void MoveRoughToExit() {
    std::array<S, L> weights = weights_;
    if (size_ == 2) {
      ray_internal::MoveAlongSide<S, L>(PointOf(1) - PointOf(0), OffExit(weights), weights[0], weights[1]);
    } else if constexpr (L == 3) {
      if (size_ == 1) return;
      const std::array<Point, 3> corners = {PointOf(0), PointOf(1), PointOf(2)};
      const Point target = height_ * Point::UnitZ() - rounding_ * normal_;
      ray_internal::MoveFromLongestSide<S, 3>(corners, target, weights);
      ray_internal::MoveAlongSides<S, 3>(corners, target, weights);
    }
    if (OffExit(weights).squaredNorm() < OffExit(weights_).squaredNorm()) weights_ = weights;
  }

  /// What heights may reach, rounding included.
  S Ceiling() const { return ceiling_ + kCeilingSlack * ceiling_; }

  /// @param added  The candidate's last point.
  bool IsBelowCeiling(const Candidate& candidate, const Point& added) const {
    return candidate.height <= Ceiling() || IsBelowCeilingButForSlope(candidate, added);
  }

  /// Of needles the flattest feature there is may be so steep that no height is nearer to the ceiling: then its plane
  /// must pass the ceiling's point on the ray within the last digit of its points.
  DGD_COLD bool IsBelowCeilingButForSlope(const Candidate& candidate, const Point& added) const {
    return (candidate.height - ceiling_) * candidate.normal[L - 1] <= kEpsilon<S> * Reach(added);
  }

  bool BasisExit(const std::array<DifferencePoint<S, L>, L>& basis, int size, Candidate& candidate) const {
    const Point& a = basis[0].point;
    if (size == 1) return ray_internal::VertexExit<S, L>(a, rounding_, candidate);
    const Point& b = basis[1].point;
    if constexpr (L == 2) {
      return ray_internal::FacetExit<S>(a, b, rounding_, candidate);
    } else {
      return size == 2 ? ray_internal::EdgeExit<S>(a, b, rounding_, candidate)
                       : ray_internal::FacetExit<S>(a, b, basis[2].point, rounding_, candidate);
    }
  }

  /// Of the added point and the basis points but `dropped`.
  bool FacetExit(int dropped, const Point& added, Candidate& candidate) const {
    if constexpr (L == 2) {
      candidate.kept = {1 - dropped};
      return ray_internal::FacetExit<S>(PointOf(candidate.kept[0]), added, rounding_, candidate) &&
             IsBelowCeiling(candidate, added);
    } else {
      candidate.kept = {(dropped + 1) % 3, (dropped + 2) % 3};
      return ray_internal::FacetExit<S>(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]), added, rounding_,
                                        candidate) &&
             IsBelowCeiling(candidate, added);
    }
  }

  /// The basis point that the added one most likely replaces: in space, the one whose wedge does not hold -added; in
  /// the plane, the one on the same side. `shift` moves all points across the ray.
  int OutgoingIndex(const Point& added, const Point& shift) const {
    const Point w = added + shift;
    if constexpr (L == 2) {
      return (PointOf(0) + shift).x() * w.x() > 0 ? 0 : 1;
    } else {
      const auto turn = [&](int i) { return ray_internal::Cross<S>(w, PointOf(i) + shift); };
      return static_cast<int>(ray_internal::OutgoingCorner<S>({turn(0), turn(1), turn(2)}));
    }
  }

  bool InsertRounded(const DifferencePoint<S, L>& added) {
    if constexpr (L == 3) {
      if (size_ == L && TakeSimplexStep<true>(added)) return true;
    }
    return InsertRoundedAmongAll(added);
  }

  /// Of all features that have the added point, the highest. Not inlined: the rarer way, and long.
  DGD_NOINLINE bool InsertRoundedAmongAll(const DifferencePoint<S, L>& added) {
    const Point& w = added.point;
    Candidate best, candidate;
    const auto keep_higher = [&] {
      if (candidate.height > best.height && IsBelowCeiling(candidate, w)) best = candidate;
    };
    if (size_ == L) {
      // The likely facet carries the ray and the dropped point lies below it.
      const int outgoing = OutgoingIndex(w, rounding_ * normal_);
      if (FacetExit(outgoing, w, candidate)) {
        if (candidate.height >= height_ && IsOutside(candidate, outgoing, added)) {
          return ReplaceOne(candidate, outgoing, added);
        }
        keep_higher();
      }
      for (int turn = 1; turn < L; ++turn) {
        if (FacetExit((outgoing + turn) % L, w, candidate)) keep_higher();
      }
    } else if (size_ == L - 1 && FacetExit(L - 1, w, candidate)) {
      keep_higher();
      if (best.height >= height_) return Replace(best, added);
    }
    if constexpr (L == 3) {
      for (int i = 0; i < size_; ++i) {
        candidate.kept = {i, -1};
        if (ray_internal::EdgeExit<S>(PointOf(i), w, rounding_, candidate)) keep_higher();
      }
    }
    if (ray_internal::VertexExit<S, L>(w, rounding_, candidate)) keep_higher();
    return Replace(best, added);
  }

  bool InsertSharp(const DifferencePoint<S, L>& added) {
    if constexpr (L == 3) {
      return TakeSimplexStep<false>(added) || InsertSharpAmongAll(added);
    } else {
      const int outgoing = OutgoingIndex(added.point, Point::Zero());
      Candidate candidate;
      if (FacetExit(outgoing, added.point, candidate) && candidate.normal[L - 1] > kSteep<S> &&
          IsOutside(candidate, outgoing, added)) {
        return ReplaceOne(candidate, outgoing, added);
      }
      return InsertSharpAmongAll(added);
    }
  }

  /// The ratio test names the facet, but for ties and rounding: most steps end here.
  template <bool kRounded>
  bool TakeSimplexStep(const DifferencePoint<S, L>& added) {
    const ray_internal::SimplexStep<S, kRounded> step({&PointOf(0), &PointOf(1), &PointOf(2)}, added.point, rounding_,
                                                      normal_);
    if (!(step.is_certain && step.height >= height_ && step.height <= Ceiling())) return false;
    points_[step.outgoing] = added;
    weights_[step.outgoing] = step.weights[0];
    weights_[step.next] = step.weights[1];
    weights_[step.last] = step.weights[2];
    direction_ = step.direction;
    normal_ = step.normal;
    AdoptHeight(step.height, false);
    return true;
  }

  /// Where the ray meets an edge or a corner of the basis, or the added point is opposite to one, several facets carry
  /// the ray, at one height but for rounding: it is one with the dropped point below it, and of those the flattest,
  /// which magnifies the rounding least.
  DGD_COLD bool InsertSharpAmongAll(const DifferencePoint<S, L>& added) {
    const int outgoing = OutgoingIndex(added.point, Point::Zero());
    SharpChoice choice;
    for (int turn = 0; turn < L; ++turn) {
      const int dropped = (outgoing + turn) % L;
      Candidate candidate;
      if (FacetExit(dropped, added.point, candidate) && choice.Take(candidate, IsOutside(candidate, dropped, added))) {
        return Replace(candidate, added);
      }
    }
    if constexpr (L == 3) ChooseBorderFacet(added, choice);
    return choice.best.size > 0 && Replace(choice.best, added);
  }

  bool IsOutside(const Candidate& candidate, int dropped, const DifferencePoint<S, L>& added) const {
    return candidate.direction.dot(PointOf(dropped) - added.point) <= 0;
  }

  /// The facets whose border the ray misses by no more than the rounding of the points: where it meets an edge of the
  /// basis and a new point lies beyond that edge, or on the ray itself, the signs of the last digits may say that no
  /// facet holds the ray, or only one seen edge-on.
  DGD_COLD void ChooseBorderFacet(const DifferencePoint<S, L>& added, SharpChoice& choice) const {
    SharpChoice careful;
    const S error = kWeightSlack<S> * Reach(added.point);
    for (int dropped = 0; dropped < L; ++dropped) {
      Candidate candidate;
      candidate.kept = {(dropped + 1) % L, (dropped + 2) % L};
      const bool is_on_edge = weights_[static_cast<std::size_t>(dropped)] <= kWeightSlack<S>;
      const bool holds_ray = is_on_edge
                                 ? TurnAboutEdge(added.point, candidate)
                                 : ray_internal::SliverExit<S>(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]),
                                                               added.point, rounding_, error, candidate);
      if (holds_ray && IsBelowCeiling(candidate, added.point)) {
        careful.Take(candidate, IsOutside(candidate, dropped, added));
      }
    }
    if (careful.best.size > 0) choice = careful;
  }

  /// For a ray that leaves through the edge of the kept points: the facet turns about it to the added point, wherever
  /// that is, and the exit stays. Whether the ray meets the edge is not asked again: when it was found to, the points
  /// may have reached farther, and their rounding with them. Test: InnerApproximation.Insert_PointAcross*.
  bool TurnAboutEdge(const Point& added, Candidate& candidate) const {
    const ray_internal::SliverNormal<S> normal(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]), added);
    if (!ray_internal::PointUpwards<S, L>(normal.cross, candidate)) return false;
    const S weight_0 = weights_[static_cast<std::size_t>(candidate.kept[0])];
    const S weight_1 = weights_[static_cast<std::size_t>(candidate.kept[1])];
    const S sum = weight_0 + weight_1;
    candidate.weights = {weight_0 / sum, weight_1 / sum, 0};
    candidate.height = height_;
    candidate.size = L;
    candidate.is_rough = true;
    return true;
  }

  /// Largest coordinate of the basis and the added point, metres.
  S Reach(const Point& added) const {
    S reach = added.cwiseAbs().maxCoeff();
    for (const DifferencePoint<S, L>& point : points_) reach = std::max(reach, point.point.cwiseAbs().maxCoeff());
    return reach;
  }

  /// Whether the exit is not lower than now by more than rounding; the bound itself is monotone. Equal heights are
  /// taken: where the ray meets an edge of the basis, a simplex step turns the plane without raising it, and may lower
  /// it by rounding many times on the way to the right plane.
  bool IsHighEnough(const Candidate& candidate, const Point& added) const {
    return candidate.height >= height_ || candidate.height >= height_ - HeightRounding(candidate, added);
  }

  /// Makes the kept points and the added one the basis if there is an exit among them, and that is high enough: far
  /// points are rounded by more than any height.
  bool Replace(const Candidate& candidate, const DifferencePoint<S, L>& added) {
    if (candidate.size == 0 || !IsHighEnough(candidate, added.point)) return false;
    // The kept points go to the front; i < j cyclically, so they may have to move in either order.
    const auto kept_count = static_cast<std::size_t>(candidate.size - 1);
    std::array<DifferencePoint<S, L>, L - 1> kept;
    for (std::size_t i = 0; i < kept_count; ++i) kept[i] = points_[static_cast<std::size_t>(candidate.kept[i])];
    for (std::size_t i = 0; i < kept_count; ++i) points_[i] = kept[i];
    points_[kept_count] = added;
    Adopt(candidate);
    return true;
  }

  /// As Replace(), for a facet of FacetExit(): the added point takes the dropped one's place, and the kept ones stay,
  /// which puts the three in the same order about the ray.
  bool ReplaceOne(const Candidate& candidate, int dropped, const DifferencePoint<S, L>& added) {
    if (!IsHighEnough(candidate, added.point)) return false;
    points_[static_cast<std::size_t>(dropped)] = added;
    AdoptExit(candidate);
    weights_[static_cast<std::size_t>(dropped)] = candidate.weights[L - 1];
    for (std::size_t i = 0; i + 1 < L; ++i)
      weights_[static_cast<std::size_t>(candidate.kept[i])] = candidate.weights[i];
    OrderAboutRay();
    return true;
  }

  /// Takes over the exit of the points that are now the basis.
  void Adopt(const Candidate& candidate) {
    AdoptExit(candidate);
    weights_ = candidate.weights;
    OrderAboutRay();
  }

  void AdoptExit(const Candidate& candidate) {
    size_ = candidate.size;
    normal_ = candidate.normal;
    DGD_ASSERT(size_ >= 1 && size_ <= L && IsUnitOrNan(normal_));
    direction_ = candidate.direction;
    AdoptHeight(candidate.height, candidate.is_rough);
  }

  void AdoptHeight(S height, bool is_rough) {
    DGD_ASSERT(!std::isnan(height));
    height_ = std::max(height_, std::min(height, ceiling_));
    is_rough_ = is_rough || height_ != height;
  }

  /// Counterclockwise, which OutgoingIndex() relies on.
  void OrderAboutRay() {
    if constexpr (L == 3) {
      if (size_ == 3 && ray_internal::Cross<S>(PointOf(1) - PointOf(0), PointOf(2) - PointOf(0)) < 0) {
        std::swap(points_[0], points_[1]);
        std::swap(weights_[0], weights_[1]);
      }
    }
  }

  /// How much lower than now an exit may be by rounding: the error of the points' coordinates across the ray, up the
  /// slope of the steeper plane.
  S HeightRounding(const Candidate& candidate, const Point& added) const {
    return kWeightSlack<S> * Reach(added) / std::max(kSteep<S>, std::min(candidate.normal[L - 1], normal_[L - 1]));
  }

  std::array<DifferencePoint<S, L>, L> points_;
  std::array<S, L> weights_{};
  Point normal_ = Point::Unit(L - 1);
  Point direction_ = Point::Unit(L - 1);
  S rounding_ = 0;
  S height_ = 0;
  S ceiling_ = std::numeric_limits<S>::infinity();
  int size_ = 0;
  bool is_rough_ = false;  // The weights' point may not be the exit.
};

}  // namespace dgd
