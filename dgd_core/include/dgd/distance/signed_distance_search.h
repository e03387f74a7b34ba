// How SignedDistance() works: it looks for the point of the Minkowski difference's border that is nearest to the origin
// of the two positions, between the supporting planes that were met and an inner approximation.
//
//  * Convex radius. C = K + ball(R), K the difference of the cores: the signed distance of C is that of K less R, along
//    the same normal. So all is done on K, and polytopes with margins end exactly.
//  * Start. The normal of the growth distance, and the basis of its inner approximation: for polytopes in contact face
//    on face they are the result already, and no support function is evaluated. Of curved cores the basis names pieces,
//    and Newton's first step is taken on all of them.
//  * Apart. With the origin outside of K the problem is convex: GJK. The nearest point of a simplex gives the next
//    direction, whose supporting plane bounds the distance from below.
//  * Overlap. With the origin inside, an expanding polytope finds the least of many local minima: epa_search.h.
//  * Frames. The points where the last search ended are named by features, and so are points of K wherever the sets
//    have moved to: no growth distance is needed in between. Polytopes most often end where they were, apart
//    or in overlap, and one evaluation of the support functions proves it. Curved cores must stay apart.
//  * Curves. The inner approximation of a curved set alone converges linearly: Newton's steps are taken in between, as
//    long as they gain, on all pieces that the simplex is on (newton_kink_step.h).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "dgd/assert.h"
#include "dgd/distance/distance_bounds.h"
#include "dgd/distance/epa.h"
#include "dgd/distance/epa_search.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/local_minimum.h"
#include "dgd/distance/newton_kink_step.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

/// @tparam DifferenceOfCores  MinkowskiDifference; for Update() of polytopes WorldDifference, too.
template <class DifferenceOfCores>
class SignedDistanceSearch {
 public:
  using Bounds = distance_internal::DistanceBounds<DifferenceOfCores>;
  using Difference = DifferenceOfCores;
  using Feature = typename Bounds::Feature;
  using Point = typename Bounds::Point;
  using S = typename Bounds::S;

  template <class Set1, class Set2>
  SignedDistanceSearch(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
                       const Settings<S>& settings)
      : bounds_(set_1, pose_1, set_2, pose_2, settings) {}
  SignedDistanceSearch(const SignedDistanceSearch&) = delete;
  SignedDistanceSearch& operator=(const SignedDistanceSearch&) = delete;

  /// @param growth      A normal and the separation along it; with a status that has none, only a direction.
  /// @param warm_start  Points of K that may be near; nullptr for none.
  Status Solve(const Result<S>& growth, const WarmStart<S>* warm_start) {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    const Point normal = difference_.DirectionFromWorld(growth.normal).normalized();
    if (!normal.allFinite()) return Status::kInvalidInput;
    if (warm_start != nullptr) RecallSimplex(*warm_start, normal);
    if (simplex_.Size() == 0 || !IsCertain(growth.status)) {
      simplex_.Add(bounds_.CutOutOfLine(normal));
    } else {
      best_.normal = normal;
      best_.height = -growth.separation - difference_.ConvexRadius();
      best_.is_new = true;
      if (Difference::kIsSmooth && best_.height > kDeep * bounds_.size) {
        simplex_ = {};
        simplex_.Add(bounds_.CutOutOfLine(Point::UnitZ()));
      }
    }
    return RunGjk();
  }

  /// Searches from the line of the centres, without a growth distance, where that is the shorter way: to a point or a
  /// segment, and between curved cores that a plane across the line separates.
  /// @return nothing if it is not.
  std::optional<Status> TryFromCenters() {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    if constexpr (Difference::kIsPolytope) {
      if (!difference_.HasThinCore()) return std::nullopt;
    } else if (!Difference::kIsSmooth) {
      return std::nullopt;
    }
    simplex_.Add(bounds_.CutOutOfLine(Point::UnitZ()));
    if (Difference::kIsSmooth && !(best_.height < 0)) return std::nullopt;
    return RunGjk();
  }

  /// Searches from where the last search ended: polytopes from its points, curved cores from its normal, or from the
  /// line of the centres.
  /// @return kOptimal or kSeparated; anything else if there is no state to begin from, or curved cores are not apart.
  Status Update(const WarmStart<S>& last) {
    is_update_ = true;
    if constexpr (Difference::kIsPolytope) {
      // A nearest simplex has three points at most.
      if (last.size > 3) return ResumeEpa(last);
      RecallSimplex(last, Point::Zero());
    } else {
      if (!difference_.IsValid()) return Status::kInvalidInput;
      const bool is_known = last.normal_1.squaredNorm() > S(0.5);  // If not, it is zero.
      const Point normal = is_known ? difference_.DirectionToFrame(last.normal_1).normalized() : Point(Point::UnitZ());
      const Feature support = bounds_.CutOutOfLine(normal);
      if (IsBeyondLimit()) return Status::kSeparated;
      RecallSimplex(last, normal);
      if (simplex_.Size() == 0) simplex_.Add(support);
    }
    return RunGjk();
  }

  /// Leaves the points, and the normal, for Update().
  void Remember(Status status, WarmStart<S>& state) const {
    if (!epa_.Leave(state)) simplex_.Leave(state);
    state.normal_1 = difference_.NormalOfSet1(best_.normal);
    if (status == Status::kSeparated) state.size = 0;
  }

  const Bounds& Found() const { return bounds_; }

 private:
  using Corners = distance_internal::Corners<S>;
  using Tangents = typename Bounds::Tangents;

  static bool IsCertain(Status status) {
    return status == Status::kOptimal || status == Status::kStalled || status == Status::kIterationLimit;
  }

  /// Calls take(point) for the points of K that a state names by features; of curved cores, for those of the same
  /// pieces along a normal.
  template <class Take>
  void ForEachPoint(const WarmStart<S>& state, const Point& normal, const Take& take) {
    DGD_ASSERT(static_cast<std::size_t>(state.size) <= state.features_1.size());
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.size); ++i) {
      const FeatureId feature_1 = state.features_1[i], feature_2 = state.features_2[i];
      // Sets may have changed since.
      if (!difference_.HasFeatures(feature_1, feature_2)) continue;
      if constexpr (Difference::kIsPolytope) {
        take(bounds_.ToDistanceOrigin(difference_.FromVertices(feature_1, feature_2)));
      } else {
        const auto piece = difference_.AlongTangents(feature_1, feature_2, normal, Bounds::TangentsAt(normal));
        take(bounds_.ToDistanceOrigin(piece.support));
      }
    }
  }

  void RecallSimplex(const WarmStart<S>& state, const Point& normal) {
    if constexpr (Difference::kHasFeatures) {
      ForEachPoint(state, normal, [this](const Feature& point) {
        if (simplex_.Size() < 3) simplex_.Append(point);
      });
      simplex_.Reduce();
    }
  }

  /// Searches from the points of the last expanding polytope; if the first four do not hold the origin any more, the
  /// cores may be apart.
  DGD_NOINLINE Status ResumeEpa(const WarmStart<S>& last) requires(Difference::kIsPolytope) {
    std::array<Feature, WarmStart<S>::kMostFeatures> points;
    std::size_t count = 0;
    ForEachPoint(last, Point::Zero(), [&](const Feature& point) { points[count++] = point; });
    if (count < 4) return StalledOrInvalid();
    EpaPolytope<S> polytope({points[0], points[1], points[2], points[3]}, bounds_.RoundoffBound(), bounds_.size,
                            bounds_.SupportError());
    if (!(polytope.Inradius() > bounds_.RoundoffBound())) {
      simplex_ = GjkSimplex<S>(polytope.CornersOf(polytope.Nearest()), 3);
      return RunGjk();
    }
    for (std::size_t i = 4; i < count; ++i) polytope.Add(points[i]);
    return epa_.RunEpa(polytope);
  }

  /// Whether the gap is small enough while the cores are apart. The witness points are off by its root, so it has to be
  /// smaller than the tolerance.
  bool HasGoodPoints() const {
    if constexpr (Difference::kIsPolytope) return bounds_.IsOptimal();
    return bounds_.nearest + best_.height <= std::max(bounds_.RoundoffBound(), kForPoints * bounds_.Tolerance());
  }
  /// Whether the cores are apart, as far as is known and in numbers that the scalar can compute with; false for NaN.
  bool IsApart() const {
    return bounds_.nearest > bounds_.RoundoffBound() && bounds_.nearest >= kLeastSize<S> &&
           bounds_.size <= kGreatestSize<S>;
  }
  Status StalledOrInvalid() const { return difference_.IsValid() ? Status::kStalled : Status::kInvalidInput; }
  bool IsBeyondLimit() const { return bounds_.Separation() > bounds_.settings.separation_limit; }

  /// Newton's step on all pieces that the simplex is on, from the last plane if that is the best and separates the
  /// cores; else the simplex's normal. A step from the latter would start worse: where cores are near each other, its
  /// error is the points' over their distance. If the pieces' points along the step are nearer, they are the simplex.
  Point NextNormalApart() {
    const Point own = simplex_.Normal();
    if constexpr (Difference::kIsSmooth) {
      // Where the cores may overlap, steps would only concentrate the points where an expanding polytope needs few.
      if (best_.height > 0 || !std::exchange(best_.is_new, false)) return own;
      const Point from = best_.normal;
      const Tangents tangents = Bounds::TangentsAt(from);
      const auto pieces = PiecesOfSimplex(from, tangents);
      const NormalStep<S> step = StepOnKink(KinkModel<S>(from, tangents, pieces.models));
      if (!step.is_valid) return own;
      // A single piece needs no more than its next support point.
      if (pieces.models.size > 1) MoveSimplex(pieces.support, step.next, tangents);
      return step.next;
    }
    return own;
  }

  /// The pieces that the simplex's points are on, about a normal, with the points' weights.
  distance_internal::Pieces<S> PiecesOfSimplex(const Point& normal,
                                               const Tangents& tangents) requires(Difference::kIsSmooth) {
    const Corners corners(simplex_);
    auto pieces = distance_internal::PiecesOf(bounds_, corners, normal, tangents);
    for (std::size_t i = 0; i < corners.size; ++i) {
      pieces.models[pieces.support.IndexOf(corners.points[i])].weight += simplex_.Weight(i);
    }
    return pieces;
  }

  /// Takes the pieces' points along another normal for the simplex, if they are nearer.
  void MoveSimplex(const Corners& corners, const Point& normal,
                   const Tangents& tangents) requires(Difference::kIsSmooth) {
    std::array<Feature, 3> moved;
    for (std::size_t i = 0; i < corners.size; ++i) {
      const Feature& from = corners.points[i];
      moved[i] =
          bounds_.ToDistanceOrigin(difference_.AlongTangents(from.feature_1, from.feature_2, normal, tangents).support);
    }
    const GjkSimplex<S> simplex(moved, corners.size);
    if (simplex.Nearest().squaredNorm() < simplex_.Nearest().squaredNorm()) simplex_ = simplex;
    bounds_.nearest = simplex_.Nearest().norm();
  }

  /// Searches about an origin that is outside of K, or seems to be.
  Status RunGjk() {
    // The size of flat sets shows in their points.
    const S extent = bounds_.Extent();
    if (extent > 0 && extent < kLeastSize<S>) return Status::kInvalidInput;
    for (;;) {
      bounds_.nearest = simplex_.Nearest().norm();
      if (is_update_ && !IsApart()) return StalledOrInvalid();
      if (bounds_.nearest <= bounds_.RoundoffBound()) return epa_.HandleBoundaryOrigin(simplex_);
      if (HasGoodPoints()) return bounds_.Finish(Status::kOptimal, simplex_.Combination());
      if (bounds_.IsExhausted()) return bounds_.Finish(Status::kIterationLimit, simplex_.Combination());
      const Point normal = NextNormalApart();
      const Feature support = bounds_.Cut(normal);
      if (HasGoodPoints()) return bounds_.Finish(Status::kOptimal, simplex_.Combination());
      if (IsBeyondLimit()) return Status::kSeparated;
      if (simplex_.HoldsOriginWith(support.point)) {
        if (is_update_ && !Difference::kIsPolytope) return Status::kStalled;
        return epa_.RunFrom({simplex_[0], simplex_[1], simplex_[2], support});
      }
      const bool is_own = !Difference::kIsSmooth || normal == simplex_.Normal();
      GjkSimplex<S> grown = simplex_;
      grown.Add(support, is_own);
      if (descent_.Continues(bounds_.nearest, grown.Nearest().norm(), bounds_.RoundoffBound())) {
        simplex_ = grown;
      } else if (is_own) {
        return bounds_.Finish(Status::kStalled, simplex_.Combination());
      }
    }
  }

  /// Smooth cores that overlap by more than this part of their size are searched from the line of the centres: of
  /// ellipsoids, an expanding polytope that begins with points all around takes 0.88 of the instructions of one that
  /// begins with those of the growth distance, of cylinders 1.02 (query_instructions.sh, `signed`).
  static constexpr S kDeep = S(1e-4);
  /// The part of the tolerance that the gap has to be below, for two digits of the points.
  static constexpr S kForPoints = S(1e-4);

  Bounds bounds_;
  const Difference& difference_ = bounds_.difference;
  typename Bounds::Plane& best_ = bounds_.best;
  distance_internal::EpaSearch<Difference> epa_{bounds_};
  GjkSimplex<S> simplex_;
  Descent<S> descent_;
  bool is_update_ = false;  // Ends where the origin is on the border of K, or inside that of curved cores.
};

}  // namespace dgd
