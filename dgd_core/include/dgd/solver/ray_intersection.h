// Alg. 3 of the paper as named steps.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/first_normal.h"
#include "dgd/solver/inner_approximation.h"
#include "dgd/solver/inner_update.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/ray_bounds.h"
#include "dgd/solver/support_pool.h"

namespace dgd {

/// One query: the ray from 0 along p against C = C1 - C2 + p, between an inner and an outer approximation.
template <class Set1, class Set2>
class RayIntersection {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  using Point = Vector<S, L>;

  RayIntersection(const Difference& difference, const Settings<S>& settings)
      : difference_(difference), settings_(settings), inner_(Start()), bounds_(difference, settings, inner_.Height()) {}

  /// Solves the query of a valid difference.
  /// @param observer  Called with an Iterate after each iteration.
  template <class Observer>
  Status Solve(QueryMode mode, WarmStart<S, L>* warm_start, Observer& observer) {
    if (!(difference_.Inradius() > 0)) return Status::kNoInterior;
    const bool has_ray = difference_.HasRay();
    const Status status =
        has_ray ? Improve(mode, FirstDirection(warm_start), observer) : MeasureAlongAnyNormal(warm_start);
    if (has_ray) FindWitness(status);
    if (warm_start != nullptr) Remember(status, *warm_start);
    return status;
  }

  int Iterations() const { return iterations_; }
  /// What the query has proven.
  const RayBounds<Difference>& Bounds() const { return bounds_; }

 private:
  using Feature = typename Difference::Feature;

  /// Where p = 0, the growth distance is 0 and every direction is a normal: the last one is taken, or x.
  Status MeasureAlongAnyNormal(const WarmStart<S, L>* warm_start) {
    Point normal = Point::UnitX();
    if (warm_start != nullptr && HasNormal(*warm_start)) {
      normal = difference_.DirectionToFrame(warm_start->normal_1);
    }
    iterations_ = 1;
    const Feature support = difference_.Support(normal, normal);
    bounds_.LowerOuter(normal, normal.dot(support.point) + difference_.ConvexRadius(), support.on_1);
    return Status::kCoincidentCenters;
  }

  /// @param normal  The first one to search.
  template <class Observer>
  Status Improve(QueryMode mode, Point normal, Observer& observer) {
    Point direction = normal;
    for (;;) {
      if (!(normal[L - 1] > 0)) return Status::kStalled;  // Also for NaN.
      const S last_outer = bounds_.Outer(), last_inner = inner_.Height();
      CutAlong(normal, direction);
      std::optional<Status> verdict = bounds_.Verdict(mode);
      // A plane between the sets is certain all the same.
      if (iterations_ == 1 && verdict != Status::kSeparated && !difference_.HasCertainInterior(support_)) {
        return Status::kNoInterior;
      }
      if (!verdict) {
        if (iterations_ == 1) RememberStart();
        RaiseInner();
        // Polytopes end with a supporting plane on the inner approximation; curved cores once a point is near enough.
        if constexpr (Difference::kIsSmooth) verdict = bounds_.Verdict(mode);
      }
      Report(observer);
      if (verdict) return *verdict;
      if (iterations_ >= settings_.max_iterations) return Status::kIterationLimit;
      // Along the normal searched last there is nothing new: the inner approximation is as high as roundoff lets it be.
      if (normal == inner_.Normal()) {
        if (!Restart()) return Status::kStalled;
        normal = inner_.Normal();
      } else {
        normal = NextNormal(last_outer, last_inner);
      }
      // Polytopes have no other normal than the inner approximation's, whose direction is there before its length.
      direction = Difference::kIsPolytope ? inner_.Direction() : normal;
    }
  }

  /// The normal of the inner approximation, or half way to it.
  Point NextNormal([[maybe_unused]] S last_outer, [[maybe_unused]] S last_inner) {
    if constexpr (!Difference::kIsPolytope) {
      const bool is_slow = bounds_.Outer() - inner_.Height() > kSlow * (last_outer - last_inner);
      is_between_ = iterations_ >= kPatience && is_slow && !is_between_;
      if (is_between_) return NormalBetween();
    }
    return inner_.Normal();
  }

  /// On thin edges and tips of curved cores the inner approximation's normals swing from side to side, and gain little.
  /// Scaled to height 1, the best normal so far and that one bound a segment; half way along it a supporting plane
  /// gains in either case: if its point raises the inner approximation, that; if not, then by convexity the plane takes
  /// half of the gap. In-out separation of cutting planes (Ben-Ameur and Neto 2007, "Acceleration of cutting-plane and
  /// column generation algorithms"). The soak's queries of 100 iterations take 10 to 30 with it; with a bisector of
  /// unit normals, which stays near the flatter one, up to 100.
  Point NormalBetween() const {
    const Point &best = bounds_.OuterDirection(), &next = inner_.Normal();
    return (next[L - 1] * best + best[L - 1] * next).normalized();
  }

  /// A basis can lose its digits: points of the same piece come close together, and steep or thin facets of polytopes
  /// magnify the roundoff of their corners. Then a new basis finishes the query; the bounds keep what was reached.
  /// @return false the second time.
  DGD_COLD bool Restart() {
    if (has_restarted_) return false;
    has_restarted_ = true;
    reached_ = inner_;
    inner_ = Start();
    return true;
  }

  /// Finds the witness points, after the last direction: those of the basis that the bound is from, by its best weights
  /// where they are a result.
  void FindWitness(Status status) {
    if (has_restarted_ && reached_.Height() > inner_.Height()) inner_ = reached_;
    if (status != Status::kSeparated) inner_.MoveToExit();
    bounds_.SetWitness(difference_.OnSet1(inner_.CorePoint1(), inner_.Normal()),
                       difference_.OnSet2(inner_.CorePoint2(), inner_.Normal()));
  }

  /// Alg. 1: a facet in the ball inside the support points, or the difference of the centres if that is thin.
  InnerApproximation<S, L> Start() const {
    const S convex_radius = difference_.ConvexRadius(), inradius = difference_.InradiusOfPoints();
    return inradius > kThin * convex_radius ? InnerApproximation<S, L>::FromInradius(
                                                  inradius, difference_.InradiusOfPoints1() / inradius, convex_radius)
                                            : InnerApproximation<S, L>::FromCenter(convex_radius);
  }

  /// Alg. 2, lines 1 and 2: support point and outer update.
  /// @param direction  The normal's, of any length.
  void CutAlong(const Point& normal, const Point& direction) {
    ++iterations_;
    support_ = difference_.Support(direction, normal, hint_1_, hint_2_);
    hint_1_ = hint_2_ = kNoFeature;
    const S support_value = normal.dot(support_.point) + difference_.ConvexRadius();
    bounds_.LowerOuter(normal, support_value / normal[L - 1], difference_.OnSet1(support_.on_1, normal));
  }

  /// Alg. 2, line 3: with the support point, and then with its combinations with the points of each set.
  void RaiseInner() {
    pool_.Remember(support_);
    // A point that is not above the feature is most often in its basis already: to insert it is long, and for nothing.
    if constexpr (Difference::kIsSmooth) {
      if (!inner_.IsAbove(support_.point, 0)) return;
    }
    InnerUpdate update(inner_, bounds_.Outer());
    if (!update.Insert(support_)) return;
    for (int i = 0; i < kMaxCombinations; ++i) {
      const Feature combined = pool_.Farthest(inner_.Direction());
      if (!inner_.IsWorthwhile(combined.point, bounds_.Outer())) break;
      if (!update.Insert(combined)) break;
    }
    bounds_.RaiseInner(inner_.Height());
  }

  /// The points that a query begins with belong to the pool, too.
  void RememberStart() {
    for (int i = 0; i < inner_.Size(); ++i) {
      if (inner_[i].feature_1 != kNoFeature) pool_.Remember(inner_[i]);
    }
  }

  /// @param last  Or null: no query before.
  /// @return the first direction to search.
  Point FirstDirection(const WarmStart<S, L>* last) {
    return last != nullptr ? AdoptLastState(*last) : FirstNormal(difference_, last);
  }

  /// Polytopes: primal warm start (Sec. III-D3). The last basis, moved with the sets, goes into the inner
  /// approximation; all at once if it still carries the ray, else point by point. Curved cores, and sets that were
  /// apart: dual warm start, the last normal begins the outer approximation. After a motion of 1 %, hulls take 1.1
  /// directions from the basis and 4.5 from the normal, which then is no facet's any more; of curved cores, the points
  /// have moved along their pieces.
  /// @return the first direction to search.
  Point AdoptLastState(const WarmStart<S, L>& warm_start) {
    hint_1_ = warm_start.features_1[0];
    hint_2_ = warm_start.features_2[0];
    if constexpr (Difference::kIsPolytope) {
      std::array<Feature, L> basis;
      int size = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(warm_start.size) && size < L; ++i) {
        if (!difference_.HasFeatures(warm_start.features_1[i], warm_start.features_2[i])) continue;
        basis[static_cast<std::size_t>(size++)] =
            difference_.FromVertices(warm_start.features_1[i], warm_start.features_2[i]);
      }
      if (size > 0) {
        if (!InnerUpdate(inner_).AdoptBasis(basis, size)) InsertEach(basis, size);
        bounds_.RaiseInner(inner_.Height());
        return inner_.Normal();
      }
    }
    return FirstNormal(difference_, &warm_start);
  }

  /// It is not inlined: the rarer of two ways, and long.
  DGD_NOINLINE void InsertEach(const std::array<Feature, L>& basis, int size) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) InnerUpdate(inner_).Insert(basis[i]);
  }

  template <class Observer>
  void Report(Observer& observer) const {
    if constexpr (!std::is_same_v<Observer, const NoObserver>) {
      observer(Iterate<S, L>{iterations_, bounds_.LowerBound(), bounds_.UpperBound(), bounds_.Normal()});
    }
  }

  /// A pair that is apart remembers its normal only: the next query tries that first, and needs no basis then.
  void Remember(Status status, WarmStart<S, L>& warm_start) const {
    warm_start.normal_1 = difference_.NormalOfSet1(bounds_.OuterDirection());
    warm_start.size = 0;
    warm_start.features_1[0] = support_.feature_1;
    warm_start.features_2[0] = support_.feature_2;
    if (status == Status::kSeparated) return;
    for (int i = 0; i < inner_.Size(); ++i) {
      if (inner_[i].feature_1 == kNoFeature || inner_[i].feature_2 == kNoFeature) continue;
      warm_start.Add(inner_[i].feature_1, inner_[i].feature_2);
    }
  }

  /// Cores with less inradius than this part of their radii begin at a point: segments and points have none.
  static constexpr S kThin = S(0.1);
  /// A step that leaves more of the gap is slow.
  static constexpr S kSlow = S(0.5);
  /// Slow steps are nothing unusual in so many directions; most queries end within them.
  static constexpr int kPatience = 6;
  /// Combined points after one direction: with one at most, meshes take 5 % more directions, with two 1 %.
  static constexpr int kMaxCombinations = 4;

  const Difference& difference_;
  const Settings<S>& settings_;
  InnerApproximation<S, L> inner_;
  InnerApproximation<S, L> reached_;  // What was reached before a restart.
  RayBounds<Difference> bounds_;
  SupportPool<S, L> pool_;
  Feature support_;                                      // Support point of the last direction.
  FeatureId hint_1_ = kNoFeature, hint_2_ = kNoFeature;  // Hints for the first one, from the last query.
  int iterations_ = 0;
  bool has_restarted_ = false;
  bool is_between_ = false;  // The next direction is not the inner approximation's.
};

}  // namespace dgd
