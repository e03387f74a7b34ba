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
//  * Overlap. With the origin inside, every face of K that holds the origin's foot is a local minimum, and nothing but
//    an inner approximation all around finds the least of them: an expanding polytope. Its nearest face bounds the
//    depth from below, supporting planes from above; faces behind the best of these, which begins with the growth
//    distance's, are not looked at.
//  * Frames. While cores stay apart, the last normal is where the next search starts: no growth distance is needed in
//    between. Of polytopes, the last nearest simplex is (warm_gjk.h).
//  * Curves. The inner approximation of a curved set alone converges linearly. So there are Newton's steps in between,
//    as long as they gain: on all pieces that the simplex is on (newton_kink_step.h), or on the one that a plane met
//    (newton_step.h). A deep overlap may ask for more points than the expanding polytope has room for: then it is begun
//    from scratch, at a smaller scale.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "dgd/assert.h"
#include "dgd/distance/epa.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/newton_kink_step.h"
#include "dgd/distance/newton_step.h"
#include "dgd/distance/plane_search.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class SignedDistanceSearch : private distance_internal::PlaneSearch<Set1, Set2> {
  using Planes = distance_internal::PlaneSearch<Set1, Set2>;

 public:
  using Planes::Iterations;
  using Planes::Normal;
  using Planes::Planes;
  using Planes::Separation;
  using typename Planes::Difference;
  using typename Planes::Feature;
  using typename Planes::Point;
  using typename Planes::S;

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
  /// and of curved cores that are far apart.
  /// @return nothing if it is not.
  std::optional<Status> TryFromCenters() {
    if (!difference_.IsValid()) return Status::kInvalidInput;
    if (!Difference::kIsSmooth && !difference_.HasThinCore()) return std::nullopt;
    simplex_.Add(Cut(Point::UnitZ()));
    if (Difference::kIsSmooth && !(best_.height < -kFar * size_)) return std::nullopt;
    return RunGjk();
  }

  /// For sets whose cores are apart, from where the last search ended, or from the line of the centres. Polytopes have
  /// a search of their own for this: warm_gjk.h.
  /// @return kOptimal or kSeparated; anything else if they are not apart.
  Status SolveApart(const WarmStart<S>& last) requires(!Difference::kIsPolytope) {
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

  /// Leaves the simplex, and the normal, for SolveApart().
  void Remember(Status status, WarmStart<S>& warm_start) const {
    warm_start.normal_1 = difference_.NormalOfSet1(best_.normal);
    simplex_.Leave(warm_start);
    if (status == Status::kSeparated) warm_start.size = 0;
  }

  S UpperBound() const { return std::max(nearest_ + SupportError(), -best_.height) - difference_.ConvexRadius(); }
  Point Witness1() const { return difference_.World1(foot_.on_1, best_.normal); }
  Point Witness2() const { return difference_.World2(foot_.on_1 - foot_.point - origin_, best_.normal); }

 private:
  using Planes::best_;
  using Planes::Cut;
  using Planes::difference_;
  using Planes::is_news_;
  using Planes::is_stationary_;
  using Planes::IsExhausted;
  using Planes::origin_;
  using Planes::RoundoffBound;
  using Planes::settings_;
  using Planes::size_;
  using Planes::SupportError;
  using Planes::TangentsAt;
  using Planes::ToDistanceOrigin;
  using Planes::Tolerance;
  using typename Planes::Tangents;

  static bool IsCertain(Status status) {
    return status == Status::kOptimal || status == Status::kStalled || status == Status::kIterationLimit;
  }

  /// The points that the growth distance ended at; of curved cores those of the same pieces along its normal.
  void AddBasis(const WarmStart<S>& warm_start, const Point& normal) requires(Difference::kHasFeatures) {
    std::array<Feature, 3> basis;
    std::size_t size = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(warm_start.size); ++i) {
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

  bool IsOptimal() const { return nearest_ + best_.height <= Tolerance(); }
  /// Apart, the points are off by the root of the gap: for their sake more is asked for than the tolerance.
  bool HasGoodPoints() const { return nearest_ + best_.height <= std::max(RoundoffBound(), kForPoints * Tolerance()); }
  /// With the origin inside K: whether no normal elsewhere is much better.
  bool IsBestElsewhere() const { return best_.height + nearest_ <= kElsewhere * best_.height; }

  /// Newton's step on all pieces that the simplex is on, from the last plane if that is the best and separates the
  /// cores; and the simplex goes with them if that brings it nearer. Else the simplex's normal: of cores that are near
  /// each other it is no good start, for its error is the points' over their distance.
  Point NextNormalApart() {
    const Point own = simplex_.Normal();
    if constexpr (Difference::kIsSmooth) {
      // Where the cores may overlap, the steps would only gather the points where an expanding polytope needs few.
      if (best_.height > 0 || !std::exchange(is_news_, false)) return own;
      const Point from = best_.normal;
      const Tangents tangents = TangentsAt(from);
      const Pieces pieces = PiecesOfSimplex(from, tangents);
      Point next;
      if (!StepOnKink<S>(from, tangents, pieces.models, next)) return own;
      // Of a single piece, the next support point will do.
      if (pieces.models.size > 1) MoveSimplex(pieces, next, tangents);
      return next;
    }
    return own;
  }

  /// Support points of pieces of the two cores, and what is known about them.
  struct Pieces {
    std::array<Feature, 3> points;
    PieceModels<S> models;
  };

  /// The pieces that the simplex's points are on, each once, about a normal.
  Pieces PiecesOfSimplex(const Point& normal, const Tangents& tangents) requires(Difference::kIsSmooth) {
    Pieces pieces;
    std::size_t& size = pieces.models.size;
    for (std::size_t i = 0; i < simplex_.Size(); ++i) {
      const Feature& corner = simplex_[i];
      std::size_t same = 0;
      while (same < size && !pieces.points[same].HasFeaturesOf(corner)) ++same;
      if (same == size) {
        const auto piece = difference_.AlongTangents(corner.feature_1, corner.feature_2, normal, tangents);
        pieces.points[same] = ToDistanceOrigin(piece.support);
        pieces.models[size++] = {pieces.points[same].point, piece.derivative, 0};
      }
      pieces.models[same].weight += simplex_.Weight(i);
    }
    return pieces;
  }

  /// Takes the pieces' points along another normal for the simplex, if they are nearer.
  void MoveSimplex(const Pieces& pieces, const Point& normal,
                   const Tangents& tangents) requires(Difference::kIsSmooth) {
    std::array<Feature, 3> moved;
    for (std::size_t i = 0; i < pieces.models.size; ++i) {
      const Feature& from = pieces.points[i];
      moved[i] = ToDistanceOrigin(difference_.AlongTangents(from.feature_1, from.feature_2, normal, tangents).support);
    }
    const GjkSimplex<S> simplex(moved, pieces.models.size);
    if (simplex.Nearest().squaredNorm() < simplex_.Nearest().squaredNorm()) simplex_ = simplex;
    nearest_ = simplex_.Nearest().norm();
  }

  /// Newton's step from a plane that is the best since the last one, else the inner approximation's normal.
  Point NextNormal(const Point& inner_normal) {
    if constexpr (Difference::kIsSmooth) {
      if (is_news_ && best_.has_support) {
        is_news_ = false;
        const Tangents tangents = TangentsAt(best_.normal);
        const auto piece =
            difference_.AlongTangents(best_.support.feature_1, best_.support.feature_2, best_.normal, tangents);
        const NormalStep<S> step = StepFrom<S>(best_.normal, best_.support.point, tangents, piece.derivative);
        is_stationary_ = step.is_valid && step.gain <= RoundoffBound();
        if (step.is_valid && !is_stationary_) return step.next;
      }
    }
    return inner_normal;
  }

  /// With the origin outside of K, or so it seems.
  Status RunGjk() {
    for (;;) {
      nearest_ = simplex_.Nearest().norm();
      if (nearest_ <= RoundoffBound()) return is_apart_ ? Status::kStalled : HandleBoundaryOrigin();
      if (HasGoodPoints()) return Finish(Status::kOptimal, simplex_.Combination());
      if (IsExhausted()) return Finish(Status::kIterationLimit, simplex_.Combination());
      const Point normal = NextNormalApart();
      const Feature support = Cut(normal);
      if (HasGoodPoints()) return Finish(Status::kOptimal, simplex_.Combination());
      if (is_apart_ && Separation() > settings_.separation_limit) return Status::kSeparated;
      if (simplex_.HoldsOriginWith(support.point)) {
        if (is_apart_) return Status::kStalled;
        return RunEpa({simplex_[0], simplex_[1], simplex_[2], support});
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

  /// The origin is on a feature of K, within roundoff: on its border, where the signed distance is 0, or inside.
  DGD_NOINLINE Status HandleBoundaryOrigin() {
    std::array<Feature, 4> corners;
    std::size_t size = simplex_.Size();
    for (std::size_t i = 0; i < size; ++i) corners[i] = simplex_[i];
    while (size < 4) {
      if (!FindCorner(corners, size)) {
        // K is flat: not a tetrahedron, and along the best plane's normal it has no extent.
        return Finish(Status::kOptimal, simplex_.Combination());
      }
      ++size;
    }
    return RunEpa(corners);
  }

  /// Finds a point of K off the affine hull of the first `size` corners, in one of the directions across that.
  bool FindCorner(std::array<Feature, 4>& corners, std::size_t size) {
    DGD_ASSERT(size >= 1 && size < 4);
    const Point& a = corners[0].point;
    // Squares of a tiny K's lengths may not be finite.
    const auto towards = [&](std::size_t i) -> Point { return (corners[i].point - a).stableNormalized(); };
    Matrix3<S> axes;
    int first = 0, last = 2;  // Of the columns that are across.
    if (size == 1) {
      axes = FrameAlong<S>(best_.normal);
    } else if (size == 2) {
      axes = FrameAlong<S>(towards(1));
      last = 1;
    } else {
      axes = FrameAlong<S>(towards(1).cross(towards(2)).normalized());
      first = 2;
    }
    for (int i = last; i >= first; --i) {
      for (const S sign : {S(1), S(-1)}) {
        const Point normal = sign * axes.col(i);
        corners[size] = Cut(normal);
        if (normal.dot(corners[size].point - a) > kFlat * RoundoffBound()) return true;
      }
    }
    return false;
  }

  /// With the origin inside K.
  DGD_NOINLINE Status RunEpa(const std::array<Feature, 4>& corners) {
    if constexpr (Difference::kIsSmooth) {
      // The growth distance's plane has no support point yet, which Newton's first step needs.
      const Point normal = best_.normal;
      best_.height = std::numeric_limits<S>::infinity();
      Cut(normal);
    }
    nearest_ = std::numeric_limits<S>::infinity();
    EpaPolytope<S> polytope(corners, SupportError(), size_);
    const auto finish = [&](Status status) { return Finish(status, polytope.NearestTo(best_.height * best_.normal)); };
    for (;;) {
      const auto& face = polytope.Nearest();
      nearest_ = std::min(nearest_, -polytope.Inradius());
      if (IsOptimal()) return finish(Status::kOptimal);
      if (is_stationary_ && IsBestElsewhere()) return finish(Status::kOptimal);
      if (IsExhausted()) return finish(Status::kIterationLimit);
      if (polytope.IsSliver(face)) return finish(Status::kStalled);
      const Point own = face.normal;
      const Point normal = NextNormal(own);
      if (polytope.Add(Cut(normal))) continue;
      if constexpr (!Difference::kIsPolytope) {
        if (polytope.IsFull()) return Refine(polytope.NearestTo(best_.height * best_.normal));
      }
      if (normal == own) return finish(Status::kStalled);
    }
  }

  /// The expanding polytope has no room for as many points as a curved set may ask for. Others take its place, of the
  /// best plane's surroundings alone, which are narrowed down from one to the next.
  /// @param of_inner  The foot so far.
  DGD_NOINLINE Status Refine(Feature of_inner) {
    constexpr int kMaxRounds = 8;
    constexpr S kNarrower = 4;
    // By which a border that curves as a ball of K's size recedes by the gap, and some more.
    S tilt = std::min(kWidest, 2 * std::sqrt((nearest_ + best_.height) / size_));
    for (int round = 0; round < kMaxRounds; ++round) {
      switch (RunEpaNearby(tilt, of_inner)) {
        case Nearby::kClosed:
          return Finish(IsBestElsewhere() ? Status::kOptimal : Status::kStalled, of_inner);
        case Nearby::kExhausted:
          return Finish(Status::kIterationLimit, of_inner);
        case Nearby::kTooNarrow:
          tilt = std::min(kWidest, kNarrower * tilt);
          break;
        case Nearby::kFull:
          tilt /= kNarrower;
      }
    }
    return Finish(Status::kStalled, of_inner);
  }

  enum class Nearby {
    kClosed,     ///< No normal nearby is better.
    kFull,       ///< Once more, nearer.
    kTooNarrow,  ///< The points differ by roundoff alone, or the best normal is beyond them.
    kExhausted,  ///< Of evaluations.
  };

  /// An expanding polytope about the best plane: a triangle of K there, whose normals are `tilt` radians aside, and the
  /// point of K that is farthest behind it. Faces that look elsewhere are none of K's, and of no account.
  DGD_NOINLINE Nearby RunEpaNearby(S tilt, Feature& of_inner) {
    // Cosine to the best plane's normal: the triangle's faces look at most kWidest aside, those to the point behind it
    // about at right angles.
    constexpr S kAside = S(0.7);
    const Point middle = best_.normal;
    const Matrix3<S> axes = FrameAlong<S>(middle);
    std::array<Feature, 4> corners;
    for (int i = 0; i < 3; ++i) {
      const S turn = 2 * std::numbers::pi_v<S> * S(i) / 3;
      const Point aside = std::cos(turn) * axes.col(0) + std::sin(turn) * axes.col(1);
      corners[static_cast<std::size_t>(i)] = Cut((middle + tilt * aside).normalized());
    }
    corners[3] = Cut(-middle);
    EpaPolytope<S> polytope(corners, SupportError(), size_);
    for (;;) {
      if (IsExhausted()) return Nearby::kExhausted;
      const auto face = polytope.NearestAlong(middle, kAside);
      if (polytope.IsSliver(face)) return Nearby::kTooNarrow;
      const Point foot = best_.height * best_.normal;
      of_inner = polytope.NearestTo(foot);
      if (best_.height - face.distance <= Tolerance()) {
        const bool is_above = (of_inner.point - foot).squaredNorm() <= Tolerance() * size_;
        return is_above ? Nearby::kClosed : Nearby::kTooNarrow;
      }
      if (!polytope.Add(Cut(face.normal))) return polytope.IsFull() ? Nearby::kFull : Nearby::kTooNarrow;
    }
  }

  /// Keeps the point of the inner approximation for the witness points; or a support point that is nearer to the
  /// plane's foot, as of smooth sets it is. Each witness point is put on its set's supporting plane, which the inner
  /// approximation is below by the gap.
  /// @param status  How the search ended, unless the bounds agree all the same.
  Status Finish(Status status, const Feature& of_inner) {
    DGD_ASSERT(IsUnitOrNan(best_.normal));
    foot_ = of_inner;
    if (best_.has_support) {
      const Feature& support = best_.support;
      const Point ideal = best_.height * best_.normal;
      if ((support.point - ideal).squaredNorm() < (foot_.point - ideal).squaredNorm()) foot_ = support;
      foot_.on_1 += best_.normal.dot(support.on_1 - foot_.on_1) * best_.normal;
      foot_.point += best_.normal.dot(support.point - foot_.point) * best_.normal;
    }
    return IsOptimal() ? Status::kOptimal : status;
  }

  /// Of the size: smooth cores that overlap by more are searched from the centres' line, since an expanding polytope
  /// that begins with points all around ends sooner than one that begins with those of the growth distance.
  static constexpr S kDeep = S(1e-4);
  /// Of the size, along the line of the centres.
  static constexpr S kFar = S(0.02);
  /// What is asked for beyond the tolerance: two digits of the points.
  static constexpr S kForPoints = S(1e-4);
  /// A tetrahedron that is thicker than so many units of roundoff has faces whose normals keep some digits.
  static constexpr S kFlat = 1024;
  /// Of a triangle about the best plane: about 30 degrees.
  static constexpr S kWidest = S(0.5);
  /// Of smooth sets: by how much of the depth a normal elsewhere may be better for a local minimum to be the answer.
  static constexpr S kElsewhere = S(0.01);

  GjkSimplex<S> simplex_;
  S nearest_ = std::numeric_limits<S>::infinity();  // Signed distance of K's inner approximation, metres.
  Feature foot_;                                    // The witness points' difference, without radii.
  Descent<S> descent_;
  bool is_apart_ = false;  // By SolveApart(): ends where the origin turns out to be inside of K.
};

}  // namespace dgd
