// The signed distance of overlapping cores: the origin of the two positions is inside their difference K, or on its
// border. See signed_distance_search.h.
//
//  * Every face of K that holds the origin's foot is a local minimum, and nothing but an inner approximation all around
//    finds the least of them: an expanding polytope. Its nearest face bounds the depth from below, supporting planes
//    from above; faces behind the best of these, which begins with the growth distance's, are not looked at.
//  * The inner approximation of a curved set alone converges linearly: between its points, Newton's steps are taken
//    from the best plane (newton_step.h); and once no normal elsewhere can be much better, down to the best nearby,
//    be it on a kink (piece_search.h). What is left is to look at the faces elsewhere. A deep overlap may need more
//    points than the polytope has room for: then it is begun from scratch, at a smaller scale.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "dgd/assert.h"
#include "dgd/distance/epa.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/newton_step.h"
#include "dgd/distance/piece_search.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"

namespace dgd::distance_internal {

/// The search about an origin inside of K, or on its border. Lengths in metres, in the ray's frame, as in PlaneSearch.
template <class Set1, class Set2>
class EpaSearch : protected PieceSearch<Set1, Set2> {
  using Base = PieceSearch<Set1, Set2>;

 public:
  using Base::Base;
  using typename Base::Difference;
  using typename Base::Feature;
  using typename Base::Point;
  using typename Base::S;

 protected:
  using Base::best_;
  using Base::Cut;
  using Base::difference_;
  using Base::is_news_;
  using Base::is_stationary_;
  using Base::IsExhausted;
  using Base::RoundoffBound;
  using Base::size_;
  using Base::SupportError;
  using Base::TangentsAt;
  using Base::Tolerance;
  using typename Base::Corners;
  using typename Base::LocalMinimum;
  using typename Base::Tangents;

  bool IsOptimal() const { return nearest_ + best_.height <= Tolerance(); }

  /// The origin is on a feature of K, within roundoff: on its border, where the signed distance is 0, or inside.
  DGD_NOINLINE Status HandleBoundaryOrigin(const GjkSimplex<S>& simplex) {
    std::array<Feature, 4> corners;
    std::size_t size = simplex.Size();
    for (std::size_t i = 0; i < size; ++i) corners[i] = simplex[i];
    while (size < 4) {
      if (!FindCorner(corners, size)) {
        // K is flat: not a tetrahedron, and along the best plane's normal it has no extent.
        return Finish(Status::kOptimal, simplex.Combination());
      }
      ++size;
    }
    return RunEpa(corners);
  }

  /// With the origin inside K.
  DGD_FLATTEN DGD_NOINLINE Status RunEpa(const std::array<Feature, 4>& corners) {
    if constexpr (Difference::kIsSmooth) StartNewtonFromBestPlane();
    nearest_ = std::numeric_limits<S>::infinity();
    EpaPolytope<S> polytope(corners, SupportError(), size_);
    const auto finish = [&](Status status) {
      if constexpr (Difference::kIsPolytope) polytope.Leave(corners_.emplace());
      if (HasMinimum()) return FinishAt(*minimum_);
      return Finish(status, polytope.NearestTo(best_.height * best_.normal));
    };
    for (;;) {
      const auto* face = &polytope.Nearest();
      nearest_ = std::min(nearest_, -polytope.Inradius());
      if (IsOptimal()) return finish(Status::kOptimal);
      if (is_stationary_ && IsBestElsewhere()) return finish(Status::kOptimal);
      if constexpr (Difference::kIsSmooth) {
        if (const auto& minimum = FindMinimum(polytope)) {
          face = polytope.NearestAside(minimum->plane.normal, kNearby);
          if (face == nullptr || best_.height - face->distance <= Tolerance()) return finish(Status::kOptimal);
        }
      }
      if (IsExhausted()) return finish(Status::kIterationLimit);
      if (polytope.IsSliver(*face)) return finish(Status::kStalled);
      const Point own = face->normal;
      const Point normal = NextNormal(own);
      if (polytope.Add(Cut(normal))) continue;
      if constexpr (!Difference::kIsPolytope) {
        if (polytope.IsFull()) return Refine(polytope);
      }
      if (normal == own) return finish(Status::kStalled);
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

  S nearest_ = std::numeric_limits<S>::infinity();  // Signed distance of K's inner approximation, metres.
  Feature foot_;                                    // The witness points' difference, without radii.
  std::optional<WarmStart<S>> corners_;             // Of the expanding polytope, at its end; of polytopes.

 private:
  /// Leaves the best plane to Newton's first step, which needs a support point: the growth distance's plane has none.
  void StartNewtonFromBestPlane() requires(Difference::kIsSmooth) {
    is_news_ = true;
    if (best_.has_support) return;
    const Point normal = best_.normal;
    best_.height = std::numeric_limits<S>::infinity();
    Cut(normal);
  }

  /// The best normal nearby the best plane's, once no normal elsewhere is much better; nothing before, and if there is
  /// none to be found. Another one where a better plane turns up elsewhere.
  const std::optional<LocalMinimum>& FindMinimum(const EpaPolytope<S>& polytope) requires(Difference::kIsSmooth) {
    if (minimum_ && !HasMinimum()) {
      minimum_.reset();
      may_descend_ = true;
    }
    if (may_descend_ && IsBestElsewhere()) {
      may_descend_ = false;
      minimum_ = this->Descend(this->CornersOf(polytope.TriangleNearestTo(best_.height * best_.normal)));
    }
    return minimum_;
  }

  /// Whether a local minimum was found, and no plane since then is better.
  bool HasMinimum() const { return minimum_ && !(best_.height < minimum_->plane.height - Tolerance()); }

  /// With a normal that is the best nearby, and none elsewhere much better. Another plane may be better by less than
  /// the tolerance, and far away: its foot is not this one's.
  Status FinishAt(const LocalMinimum& minimum) {
    best_ = minimum.plane;
    return Finish(Status::kOptimal, minimum.foot);
  }

  /// With the origin inside K: whether no normal elsewhere is much better.
  bool IsBestElsewhere() const { return best_.height + nearest_ <= kElsewhere * best_.height; }

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

  /// The expanding polytope has no room for as many points as a curved set may ask for. A normal that is the best
  /// nearby ends the search if none elsewhere is much better. Else others take the polytope's place, of the best
  /// plane's surroundings alone, which are narrowed down from one to the next.
  DGD_NOINLINE Status Refine(const EpaPolytope<S>& polytope) {
    const Point target = best_.height * best_.normal;
    const GjkSimplex<S> triangle = polytope.TriangleNearestTo(target);
    if constexpr (Difference::kIsSmooth) {
      if (!HasMinimum()) minimum_ = this->Descend(this->CornersOf(triangle));
      if (minimum_ && IsBestElsewhere()) return FinishAt(*minimum_);
    }
    Feature of_inner = triangle.Combination();
    of_inner.point += target;
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

  std::optional<LocalMinimum> minimum_;
  bool may_descend_ = true;  // No descent was tried, or a better plane has turned up since.

  /// A tetrahedron that is thicker than so many units of roundoff has faces whose normals keep some digits.
  static constexpr S kFlat = 1024;
  /// Cosine to a local minimum's normal of those that it is taken to be the best of: 3.6 degrees. Of 84000 pairs of
  /// curved sets in overlap, none ends 1e-4 of the depth above what the polytope alone finds; with 8 degrees, 11 do, by
  /// up to 0.7 %.
  static constexpr S kNearby = S(0.998);
  /// Of a triangle about the best plane: about 30 degrees.
  static constexpr S kWidest = S(0.5);
  /// Of smooth sets: by how much of the depth a normal elsewhere may be better for a local minimum to be the answer.
  static constexpr S kElsewhere = S(0.01);
};

}  // namespace dgd::distance_internal
