// How SignedDistance() works: it looks for the point of the Minkowski difference's border that is nearest to the origin
// of the two positions, between the supporting planes that were met and an inner approximation.
//
//  * Convex radius. C = K + ball(R), K the difference of the cores: the signed distance of C is that of K less R, along
//    the same normal. So all is done on K, and polytopes with margins end exactly.
//  * Start. The normal of the growth distance, and the basis of its inner approximation: for polytopes in contact face
//    on face they are the answer already, and no support function is evaluated. Of curved cores the basis names pieces,
//    and Newton's first step is taken on all of them.
//  * Apart. With the origin outside of K the problem is convex: GJK. The nearest point of a simplex gives the next
//    direction, whose supporting plane bounds the distance from below.
//  * Overlap. With the origin inside, an expanding polytope finds the least of many local minima: epa_search.h.
//  * Frames. While cores stay apart, the last normal is where the next search starts: no growth distance is needed in
//    between. Polytopes have a search of their own, apart and in overlap (warm_distance.h).
//  * Curves. The inner approximation of a curved set alone converges linearly. So there are Newton's steps in between,
//    as long as they gain, on all pieces that the simplex is on (newton_kink_step.h).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "dgd/distance/epa_search.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/newton_kink_step.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class SignedDistanceSearch : private distance_internal::EpaSearch<Set1, Set2> {
  using Overlap = distance_internal::EpaSearch<Set1, Set2>;

 public:
  using Overlap::Iterations;
  using Overlap::Normal;
  using Overlap::Overlap;
  using Overlap::Separation;
  using typename Overlap::Difference;
  using typename Overlap::Feature;
  using typename Overlap::Point;
  using typename Overlap::S;

  /// @param growth      What is known: a normal and the separation along it. Without a status that says so, only a
  ///                    direction.
  /// @param warm_start  Points of K that may be near; nullptr for none.
  Status Solve(const Result<S>& growth, const WarmStart<S>* warm_start) {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    const Point normal = difference_.DirectionFromWorld(growth.normal).normalized();
    if (!normal.allFinite()) return Status::kInvalidInput;
    if constexpr (Difference::kHasFeatures) {
      if (warm_start != nullptr) AddBasis(*warm_start, normal);
    }
    if (simplex_.Size() == 0 || !IsCertain(growth.status)) {
      simplex_.Add(Cut(normal));
    } else {
      best_.normal = normal;
      best_.height = -growth.separation - difference_.ConvexRadius();
      is_news_ = true;
      if constexpr (Difference::kIsSmooth) {
        if (best_.height > kDeep * size_) {
          simplex_ = {};
          simplex_.Add(Cut(Point::UnitZ()));
        }
      }
    }
    return RunGjk();
  }

  /// Without a growth distance, from the line of the centres, where that is the shorter way: to a point or a segment,
  /// and between curved cores that a plane across the line separates.
  /// @return nothing if it is not.
  std::optional<Status> TryFromCenters() {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    if (!Difference::kIsSmooth && !difference_.HasThinCore()) return std::nullopt;
    simplex_.Add(Cut(Point::UnitZ()));
    if (Difference::kIsSmooth && !(best_.height < 0)) return std::nullopt;
    return RunGjk();
  }

  /// For sets whose cores are apart, from where the last search ended, or from the line of the centres. Polytopes have
  /// a search of their own for this: warm_distance.h.
  /// @return kOptimal or kSeparated; anything else if they are not apart.
  Status Solve(const WarmStart<S>& last) requires(!Difference::kIsPolytope) {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    is_apart_ = true;
    const bool is_known = last.normal_1.squaredNorm() > S(0.5);  // Else it is zero.
    const Point normal = is_known ? difference_.DirectionToFrame(last.normal_1).normalized() : Point(Point::UnitZ());
    const Feature support = Cut(normal);
    if (Separation() > settings_.separation_limit) return Status::kSeparated;
    if constexpr (Difference::kHasFeatures) AddBasis(last, normal);
    if (simplex_.Size() == 0) simplex_.Add(support);
    return RunGjk();
  }

  /// Leaves the simplex, and the normal, for Solve(last).
  void Remember(Status status, WarmStart<S>& warm_start) const {
    if (corners_) {
      warm_start = *corners_;
    } else {
      simplex_.Leave(warm_start);
    }
    warm_start.normal_1 = difference_.NormalOfSet1(best_.normal);
    if (status == Status::kSeparated) warm_start.size = 0;
  }

  S UpperBound() const { return std::max(nearest_ + SupportError(), -best_.height) - difference_.ConvexRadius(); }
  Point Witness1() const { return difference_.World1(foot_.on_1, best_.normal); }
  Point Witness2() const { return difference_.World2(foot_.on_1 - foot_.point - origin_, best_.normal); }

 private:
  using Overlap::best_;
  using Overlap::corners_;
  using Overlap::Cut;
  using Overlap::difference_;
  using Overlap::Finish;
  using Overlap::foot_;
  using Overlap::is_news_;
  using Overlap::IsExhausted;
  using Overlap::IsOptimal;
  using Overlap::nearest_;
  using Overlap::origin_;
  using Overlap::RoundoffBound;
  using Overlap::settings_;
  using Overlap::size_;
  using Overlap::SupportError;
  using Overlap::TangentsAt;
  using Overlap::ToDistanceOrigin;
  using Overlap::Tolerance;
  using typename Overlap::Corners;
  using typename Overlap::Pieces;
  using typename Overlap::Tangents;

  static bool IsCertain(Status status) {
    return status == Status::kOptimal || status == Status::kStalled || status == Status::kIterationLimit;
  }

  /// The points that the growth distance ended at; of curved cores those of the same pieces along its normal.
  void AddBasis(const WarmStart<S>& warm_start, const Point& normal) requires(Difference::kHasFeatures) {
    std::array<Feature, 3> basis;
    std::size_t size = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(warm_start.size) && size < basis.size(); ++i) {
      const FeatureId feature_1 = warm_start.features_1[i], feature_2 = warm_start.features_2[i];
      if (!difference_.HasFeatures(feature_1, feature_2)) continue;
      if constexpr (Difference::kIsPolytope) {
        basis[size++] = ToDistanceOrigin(difference_.FromVertices(feature_1, feature_2));
      } else {
        const auto piece = difference_.AlongTangents(feature_1, feature_2, normal, TangentsAt(normal));
        basis[size++] = ToDistanceOrigin(piece.support);
      }
    }
    simplex_ = {basis, size};
  }

  /// With the cores apart. The witness points are off by the root of the gap, so the gap has to be smaller than the
  /// tolerance.
  bool HasGoodPoints() const { return nearest_ + best_.height <= std::max(RoundoffBound(), kForPoints * Tolerance()); }

  /// Newton's step on all pieces that the simplex is on, from the last plane if that is the best and separates the
  /// cores; else the simplex's normal. A step from the latter would start worse: where cores are near each other, its
  /// error is the points' over their distance. If the pieces' points along the step are nearer, they are the simplex.
  Point NextNormalApart() {
    const Point own = simplex_.Normal();
    if constexpr (Difference::kIsSmooth) {
      // Where the cores may overlap, steps would only concentrate the points where an expanding polytope needs few.
      if (best_.height > 0 || !std::exchange(is_news_, false)) return own;
      const Point from = best_.normal;
      const Tangents tangents = TangentsAt(from);
      const Pieces pieces = PiecesOfSimplex(from, tangents);
      const NormalStep<S> step = StepOnKink(KinkModel<S>(from, tangents, pieces.models));
      if (!step.is_valid) return own;
      // Of a single piece, the next support point will do.
      if (pieces.models.size > 1) MoveSimplex(pieces.support, step.next, tangents);
      return step.next;
    }
    return own;
  }

  /// The pieces that the simplex's points are on, about a normal, with the points' weights.
  Pieces PiecesOfSimplex(const Point& normal, const Tangents& tangents) requires(Difference::kIsSmooth) {
    const Corners corners = this->CornersOf(simplex_);
    Pieces pieces = this->PiecesOf(corners, normal, tangents);
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
      moved[i] = ToDistanceOrigin(difference_.AlongTangents(from.feature_1, from.feature_2, normal, tangents).support);
    }
    const GjkSimplex<S> simplex(moved, corners.size);
    if (simplex.Nearest().squaredNorm() < simplex_.Nearest().squaredNorm()) simplex_ = simplex;
    nearest_ = simplex_.Nearest().norm();
  }

  /// With the origin outside of K, or so it seems.
  Status RunGjk() {
    for (;;) {
      nearest_ = simplex_.Nearest().norm();
      if (nearest_ <= RoundoffBound()) return is_apart_ ? Status::kStalled : this->HandleBoundaryOrigin(simplex_);
      if (HasGoodPoints()) return Finish(Status::kOptimal, simplex_.Combination());
      if (IsExhausted()) return Finish(Status::kIterationLimit, simplex_.Combination());
      const Point normal = NextNormalApart();
      const Feature support = Cut(normal);
      if (HasGoodPoints()) return Finish(Status::kOptimal, simplex_.Combination());
      if (is_apart_ && Separation() > settings_.separation_limit) return Status::kSeparated;
      if (simplex_.HoldsOriginWith(support.point)) {
        if (is_apart_) return Status::kStalled;
        return this->RunEpa({simplex_[0], simplex_[1], simplex_[2], support});
      }
      GjkSimplex<S> grown = simplex_;
      grown.Add(support);
      if (descent_.Continues(simplex_.Nearest().squaredNorm(), grown.Nearest().squaredNorm())) {
        simplex_ = grown;
      } else if (normal == simplex_.Normal()) {
        return Finish(Status::kStalled, simplex_.Combination());
      }
    }
  }

  /// Part of the size. Smooth cores that overlap by more are searched from the line of the centres: of ellipsoids, an
  /// expanding polytope that begins with points all around takes 0.88 of the instructions of one that begins with those
  /// of the growth distance, of cylinders 1.02 (query_instructions.sh, `signed`).
  static constexpr S kDeep = S(1e-4);
  /// Part of the tolerance that the gap has to be below: two digits of the points.
  static constexpr S kForPoints = S(1e-4);

  GjkSimplex<S> simplex_;
  Descent<S> descent_;
  bool is_apart_ = false;  // By Solve(last): ends where the origin turns out to be inside of K.
};

}  // namespace dgd
