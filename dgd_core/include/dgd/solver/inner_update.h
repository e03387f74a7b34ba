// How the inner approximation takes in another point: the step from one basis to the next.
//
// Let h be the old height, reached on a feature F with normal n, and w the support point of K along n. If <n, w>
// exceeds the value on F, the old exit point is interior to conv(F, w) + ball(R), so the ray now leaves it higher, and
// through a feature that has w: one without w belongs to conv(F) and cannot be higher than h. The new basis is the
// highest of the features of conv(F, w) that have w and that the ray crosses (at most three triangles, three edges and
// w itself). Otherwise F is optimal. Heights rise strictly, and K of two polytopes has finitely many vertices: so
// rounded polytopes end after finitely many steps, as sharp ones do.
//
// Without a radius only triangles can carry the ray, and this is the paper's simplex step: the rays from the origin
// through the three projected points divide the plane, and the two that span the wedge of -w stay. That is the ratio
// test (eq. outgoing index) in barycentric coordinates.
//
// All coordinates are in the ray frame: the last one is the height along the ray, those before run across it.
#pragma once

#include <array>
#include <limits>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/solver/feature_exit.h"
#include "dgd/solver/inner_approximation.h"
#include "dgd/solver/simplex_step.h"
#include "dgd/solver/tolerances.h"
#include "dgd/solver/triangle_crossing.h"

namespace dgd {

/// Steps from one basis to the next.
template <class S, int L>
class InnerUpdate {
 public:
  using Point = Vector<S, L>;

  /// @param inner    Changed by what follows.
  /// @param ceiling  A height that C does not reach beyond. A feature that does, by more than roundoff, has lost its
  ///                 digits and is not taken.
  explicit InnerUpdate(InnerApproximation<S, L>& inner, S ceiling = std::numeric_limits<S>::infinity())
      : inner_(inner), ceiling_(ceiling) {}

  /// Adds a point of the cores' difference and keeps the feature through which the ray now leaves.
  /// @return whether the approximation changed; its height never falls. False also where roundoff leaves no feature.
  bool Insert(const DifferencePoint<S, L>& added) {
    DGD_ASSERT(inner_.Size() >= 1 && inner_.Size() <= L);
    return inner_.ConvexRadius() > 0 ? InsertWithRadius(added) : InsertSharp(added);
  }

  /// Takes over a whole basis, one to L points of the cores' difference that were the feature of an earlier query,
  /// if the ray leaves through the same feature, not lower than so far.
  bool AdoptBasis(const std::array<DifferencePoint<S, L>, L>& basis, int size) {
    if (size < 1 || (inner_.ConvexRadius() == 0 && size < L)) return false;
    Candidate candidate;
    if (!BasisExit(basis, size, candidate) || !(candidate.height >= inner_.Height())) return false;
    inner_.Adopt(basis, candidate);
    return true;
  }

 private:
  using Candidate = typename InnerApproximation<S, L>::Candidate;

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
    return (candidate.height - ceiling_) * candidate.normal[L - 1] <= kEpsilon<S> * inner_.Reach(added);
  }

  bool BasisExit(const std::array<DifferencePoint<S, L>, L>& basis, int size, Candidate& candidate) const {
    const Point& a = basis[0].point;
    if (size == 1) return solver_internal::VertexExit<S, L>(a, inner_.ConvexRadius(), candidate);
    const Point& b = basis[1].point;
    if constexpr (L == 2) {
      return solver_internal::FacetExit<S>(a, b, inner_.ConvexRadius(), candidate);
    } else {
      return size == 2 ? solver_internal::EdgeExit<S>(a, b, inner_.ConvexRadius(), candidate)
                       : solver_internal::FacetExit<S>(a, b, basis[2].point, inner_.ConvexRadius(), candidate);
    }
  }

  /// Exit by the facet of the added point and the basis points but `dropped`.
  bool FacetExit(int dropped, const Point& added, Candidate& candidate) const {
    if constexpr (L == 2) {
      candidate.kept = {1 - dropped};
      return solver_internal::FacetExit<S>(inner_.PointOf(candidate.kept[0]), added, inner_.ConvexRadius(),
                                           candidate) &&
             IsBelowCeiling(candidate, added);
    } else {
      candidate.kept = {(dropped + 1) % 3, (dropped + 2) % 3};
      return solver_internal::FacetExit<S>(inner_.PointOf(candidate.kept[0]), inner_.PointOf(candidate.kept[1]), added,
                                           inner_.ConvexRadius(), candidate) &&
             IsBelowCeiling(candidate, added);
    }
  }

  /// The basis point that the added one most likely replaces: in space, the one whose wedge does not hold -added; in
  /// the plane, the one on the same side. `shift` moves all points across the ray.
  int OutgoingIndex(const Point& added, const Point& shift) const {
    const Point w = added + shift;
    if constexpr (L == 2) {
      return (inner_.PointOf(0) + shift).x() * w.x() > 0 ? 0 : 1;
    } else {
      const auto turn = [&](int i) { return solver_internal::Cross<S>(w, inner_.PointOf(i) + shift); };
      return static_cast<int>(solver_internal::OutgoingCorner<S>({turn(0), turn(1), turn(2)}));
    }
  }

  bool InsertWithRadius(const DifferencePoint<S, L>& added) {
    if constexpr (L == 3) {
      if (inner_.Size() == L && TakeSimplexStep<true>(added)) return true;
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
    if (inner_.Size() == L) {
      // The likely facet carries the ray and the dropped point lies below it.
      const int outgoing = OutgoingIndex(w, inner_.ConvexRadius() * inner_.Normal());
      if (FacetExit(outgoing, w, candidate)) {
        if (candidate.height >= inner_.Height() && IsOutside(candidate, outgoing, added)) {
          return inner_.ReplaceOne(candidate, outgoing, added, ceiling_);
        }
        keep_higher();
      }
      for (int turn = 1; turn < L; ++turn) {
        if (FacetExit((outgoing + turn) % L, w, candidate)) keep_higher();
      }
    } else if (inner_.Size() == L - 1 && FacetExit(L - 1, w, candidate)) {
      keep_higher();
      if (best.height >= inner_.Height()) return inner_.Replace(best, added, ceiling_);
    }
    if constexpr (L == 3) {
      for (int i = 0; i < inner_.Size(); ++i) {
        candidate.kept = {i, -1};
        if (solver_internal::EdgeExit<S>(inner_.PointOf(i), w, inner_.ConvexRadius(), candidate)) keep_higher();
      }
    }
    if (solver_internal::VertexExit<S, L>(w, inner_.ConvexRadius(), candidate)) keep_higher();
    return inner_.Replace(best, added, ceiling_);
  }

  bool InsertSharp(const DifferencePoint<S, L>& added) {
    if constexpr (L == 3) {
      return TakeSimplexStep<false>(added) || InsertSharpAmongAll(added);
    } else {
      const int outgoing = OutgoingIndex(added.point, Point::Zero());
      Candidate candidate;
      if (FacetExit(outgoing, added.point, candidate) && candidate.normal[L - 1] > kSteep<S> &&
          IsOutside(candidate, outgoing, added)) {
        return inner_.ReplaceOne(candidate, outgoing, added, ceiling_);
      }
      return InsertSharpAmongAll(added);
    }
  }

  /// The ratio test names the facet, but for ties and roundoff: most steps end here.
  template <bool kHasRadius>
  bool TakeSimplexStep(const DifferencePoint<S, L>& added) {
    const solver_internal::SimplexStep<S, kHasRadius> step({&inner_.PointOf(0), &inner_.PointOf(1), &inner_.PointOf(2)},
                                                           added.point, inner_.ConvexRadius(), inner_.Normal());
    if (!(step.is_certain && step.height >= inner_.Height() && step.height <= Ceiling())) return false;
    inner_.Replace(step, added, ceiling_);
    return true;
  }

  /// Several facets carry the ray, at one height but for roundoff, where it meets an edge or a corner of the basis, or
  /// the added point is opposite to one: it is one with the dropped point below it, and of those the flattest, which
  /// magnifies the roundoff least.
  DGD_COLD bool InsertSharpAmongAll(const DifferencePoint<S, L>& added) {
    const int outgoing = OutgoingIndex(added.point, Point::Zero());
    SharpChoice choice;
    for (int turn = 0; turn < L; ++turn) {
      const int dropped = (outgoing + turn) % L;
      Candidate candidate;
      if (FacetExit(dropped, added.point, candidate) && choice.Take(candidate, IsOutside(candidate, dropped, added))) {
        return inner_.Replace(candidate, added, ceiling_);
      }
    }
    if constexpr (L == 3) ChooseBorderFacet(added, choice);
    return choice.best.size > 0 && inner_.Replace(choice.best, added, ceiling_);
  }

  bool IsOutside(const Candidate& candidate, int dropped, const DifferencePoint<S, L>& added) const {
    return candidate.direction.dot(inner_.PointOf(dropped) - added.point) <= 0;
  }

  /// The facets whose border the ray misses by no more than the roundoff of the points: where it meets an edge of the
  /// basis and a new point lies beyond that edge, or on the ray itself, by the signs of the last digits no
  /// facet may hold the ray, or only one seen edge-on.
  DGD_COLD void ChooseBorderFacet(const DifferencePoint<S, L>& added, SharpChoice& choice) const {
    SharpChoice careful;
    const S error = kWeightSlack<S> * inner_.Reach(added.point);
    for (int dropped = 0; dropped < L; ++dropped) {
      Candidate candidate;
      candidate.kept = {(dropped + 1) % L, (dropped + 2) % L};
      const bool is_on_edge = inner_.Weight(dropped) <= kWeightSlack<S>;
      const bool holds_ray = is_on_edge ? TurnAboutEdge(added.point, candidate)
                                        : solver_internal::SliverExit<S>(inner_.PointOf(candidate.kept[0]),
                                                                         inner_.PointOf(candidate.kept[1]), added.point,
                                                                         inner_.ConvexRadius(), error, candidate);
      if (holds_ray && IsBelowCeiling(candidate, added.point)) {
        careful.Take(candidate, IsOutside(candidate, dropped, added));
      }
    }
    if (careful.best.size > 0) choice = careful;
  }

  /// Turns the facet about the edge of the kept points, through which the ray leaves, to the added point, wherever that
  /// is; the exit stays. Whether the ray meets the edge is not tested again: when it was found to, the points may have
  /// reached farther, and their roundoff with them. Test: InnerApproximation.Insert_PointAcross*.
  bool TurnAboutEdge(const Point& added, Candidate& candidate) const {
    const solver_internal::SliverNormal<S> normal(inner_.PointOf(candidate.kept[0]), inner_.PointOf(candidate.kept[1]),
                                                  added);
    if (!solver_internal::PointUpwards<S, L>(normal.cross, candidate)) return false;
    const S weight_0 = inner_.Weight(candidate.kept[0]);
    const S weight_1 = inner_.Weight(candidate.kept[1]);
    const S sum = weight_0 + weight_1;
    candidate.weights = {weight_0 / sum, weight_1 / sum, 0};
    candidate.height = inner_.Height();
    candidate.size = L;
    candidate.is_rough = true;
    return true;
  }

  InnerApproximation<S, L>& inner_;
  const S ceiling_;
};

}  // namespace dgd
