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
#include "dgd/solver/feature_exit.h"
#include "dgd/solver/inner_basis.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/simplex_step.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

namespace solver_internal {
/// Sine of 120 degrees; the cosine is -1/2.
template <class S>
inline constexpr S kSineOfThirdTurn = S(0.86602540378443865);
}  // namespace solver_internal

template <class S, int L = 3>
class InnerApproximation : public solver_internal::InnerBasis<S, L> {
  using Basis = solver_internal::InnerBasis<S, L>;

 public:
  using Point = Vector<S, L>;

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

  /// Adds a point of the cores' difference and keeps the feature through which the ray now leaves.
  /// @param ceiling  A height that C does not reach beyond. A feature that does, by more than roundoff, has lost its
  ///                 digits and is not taken.
  /// @return whether the approximation changed; its height never falls. False also where roundoff leaves no feature.
  bool Insert(const DifferencePoint<S, L>& added, S ceiling = std::numeric_limits<S>::infinity()) {
    ceiling_ = ceiling;
    DGD_ASSERT(size_ >= 1 && size_ <= L);
    return convex_radius_ > 0 ? InsertWithRadius(added) : InsertSharp(added);
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

  /// Takes over a whole basis, one to L points of the cores' difference that were the feature of an earlier query,
  /// if the ray leaves through the same feature, not lower than so far.
  bool AdoptBasis(const std::array<DifferencePoint<S, L>, L>& basis, int size) {
    if (size < 1 || (convex_radius_ == 0 && size < L)) return false;
    Candidate candidate;
    if (!BasisExit(basis, size, candidate) || !(candidate.height >= height_)) return false;
    points_ = basis;
    Adopt(candidate);
    return true;
  }

 private:
  using Basis::Adopt;
  using Basis::AdoptHeight;
  using Basis::ceiling_;
  using Basis::convex_radius_;
  using Basis::direction_;
  using Basis::height_;
  using Basis::IsHighEnough;
  using Basis::normal_;
  using Basis::PointOf;
  using Basis::points_;
  using Basis::Reach;
  using Basis::Replace;
  using Basis::ReplaceOne;
  using Basis::size_;
  using Basis::weights_;
  using typename Basis::Candidate;

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

  /// Steep features magnify the roundoff of their points to heights that are off by less than this part.
  static constexpr S kCeilingSlack = sizeof(S) == 8 ? 4 * kSqrtEpsilon<S> : kSqrtEpsilon<S> / 16;

  /// Height that none may be above, roundoff included.
  S Ceiling() const { return ceiling_ + kCeilingSlack * ceiling_; }

  /// @param added  The candidate's last point.
  bool IsBelowCeiling(const Candidate& candidate, const Point& added) const {
    return candidate.height <= Ceiling() || IsBelowCeilingButForSlope(candidate, added);
  }

  /// The flattest feature of a needle may be so steep that no height is nearer to the ceiling: then its plane
  /// must pass the ceiling's point on the ray within the last digit of its points.
  DGD_COLD bool IsBelowCeilingButForSlope(const Candidate& candidate, const Point& added) const {
    return (candidate.height - ceiling_) * candidate.normal[L - 1] <= kEpsilon<S> * Reach(added);
  }

  bool BasisExit(const std::array<DifferencePoint<S, L>, L>& basis, int size, Candidate& candidate) const {
    const Point& a = basis[0].point;
    if (size == 1) return solver_internal::VertexExit<S, L>(a, convex_radius_, candidate);
    const Point& b = basis[1].point;
    if constexpr (L == 2) {
      return solver_internal::FacetExit<S>(a, b, convex_radius_, candidate);
    } else {
      return size == 2 ? solver_internal::EdgeExit<S>(a, b, convex_radius_, candidate)
                       : solver_internal::FacetExit<S>(a, b, basis[2].point, convex_radius_, candidate);
    }
  }

  /// Exit by the facet of the added point and the basis points but `dropped`.
  bool FacetExit(int dropped, const Point& added, Candidate& candidate) const {
    if constexpr (L == 2) {
      candidate.kept = {1 - dropped};
      return solver_internal::FacetExit<S>(PointOf(candidate.kept[0]), added, convex_radius_, candidate) &&
             IsBelowCeiling(candidate, added);
    } else {
      candidate.kept = {(dropped + 1) % 3, (dropped + 2) % 3};
      return solver_internal::FacetExit<S>(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]), added,
                                           convex_radius_, candidate) &&
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
      const auto turn = [&](int i) { return solver_internal::Cross<S>(w, PointOf(i) + shift); };
      return static_cast<int>(solver_internal::OutgoingCorner<S>({turn(0), turn(1), turn(2)}));
    }
  }

  bool InsertWithRadius(const DifferencePoint<S, L>& added) {
    if constexpr (L == 3) {
      if (size_ == L && TakeSimplexStep<true>(added)) return true;
    }
    return InsertWithRadiusAmongAll(added);
  }

  /// The highest of all features that have the added point. Not inlined: the rarer way, and long.
  DGD_NOINLINE bool InsertWithRadiusAmongAll(const DifferencePoint<S, L>& added) {
    const Point& w = added.point;
    Candidate best, candidate;
    const auto keep_higher = [&] {
      if (candidate.height > best.height && IsBelowCeiling(candidate, w)) best = candidate;
    };
    if (size_ == L) {
      // The likely facet carries the ray and the dropped point lies below it.
      const int outgoing = OutgoingIndex(w, convex_radius_ * normal_);
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
        if (solver_internal::EdgeExit<S>(PointOf(i), w, convex_radius_, candidate)) keep_higher();
      }
    }
    if (solver_internal::VertexExit<S, L>(w, convex_radius_, candidate)) keep_higher();
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

  /// The ratio test names the facet, but for ties and roundoff: most steps end here.
  template <bool kHasRadius>
  bool TakeSimplexStep(const DifferencePoint<S, L>& added) {
    const solver_internal::SimplexStep<S, kHasRadius> step({&PointOf(0), &PointOf(1), &PointOf(2)}, added.point,
                                                           convex_radius_, normal_);
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
  /// the ray, at one height but for roundoff: it is one with the dropped point below it, and of those the flattest,
  /// which magnifies the roundoff least.
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

  /// The facets whose border the ray misses by no more than the roundoff of the points: where it meets an edge of the
  /// basis and a new point lies beyond that edge, or on the ray itself, the signs of the last digits may say that no
  /// facet holds the ray, or only one seen edge-on.
  DGD_COLD void ChooseBorderFacet(const DifferencePoint<S, L>& added, SharpChoice& choice) const {
    SharpChoice careful;
    const S error = kWeightSlack<S> * Reach(added.point);
    for (int dropped = 0; dropped < L; ++dropped) {
      Candidate candidate;
      candidate.kept = {(dropped + 1) % L, (dropped + 2) % L};
      const bool is_on_edge = weights_[static_cast<std::size_t>(dropped)] <= kWeightSlack<S>;
      const bool holds_ray =
          is_on_edge ? TurnAboutEdge(added.point, candidate)
                     : solver_internal::SliverExit<S>(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]),
                                                      added.point, convex_radius_, error, candidate);
      if (holds_ray && IsBelowCeiling(candidate, added.point)) {
        careful.Take(candidate, IsOutside(candidate, dropped, added));
      }
    }
    if (careful.best.size > 0) choice = careful;
  }

  /// For a ray that leaves through the edge of the kept points: the facet turns about it to the added point, wherever
  /// that is, and the exit stays. Whether the ray meets the edge is not asked again: when it was found to, the points
  /// may have reached farther, and their roundoff with them. Test: InnerApproximation.Insert_PointAcross*.
  bool TurnAboutEdge(const Point& added, Candidate& candidate) const {
    const solver_internal::SliverNormal<S> normal(PointOf(candidate.kept[0]), PointOf(candidate.kept[1]), added);
    if (!solver_internal::PointUpwards<S, L>(normal.cross, candidate)) return false;
    const S weight_0 = weights_[static_cast<std::size_t>(candidate.kept[0])];
    const S weight_1 = weights_[static_cast<std::size_t>(candidate.kept[1])];
    const S sum = weight_0 + weight_1;
    candidate.weights = {weight_0 / sum, weight_1 / sum, 0};
    candidate.height = height_;
    candidate.size = L;
    candidate.is_rough = true;
    return true;
  }
};

}  // namespace dgd
