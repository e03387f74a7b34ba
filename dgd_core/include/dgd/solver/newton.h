// Curved sets' queries: from normal to normal by second-order steps, to the lowest supporting plane.
//
// A second-order step needs the pieces of C that are about the highest along one normal. They bound the ray from both
// sides:
//  * outer: the plane of the highest piece;
//  * inner: their points' convex combination z that is nearest to the ray. C holds it and the ball of radius r about
//    the origin, so at a distance d from the ray and a height h it proves that C holds the ray up to h r / (r + d).
// The distance goes to 0 quadratically, as do the bounds' gap and the error of the witness points. A step takes 0.3 to
// 0.6 of the time of one of RayIntersection; where this gives up, that goes on (query.h).
//
// A step that goes too far has met a higher piece: a new one takes part in the next step, another by its plane there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/flat_face.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/newton_step.h"
#include "dgd/solver/ray_bounds.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class NewtonSearch {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using Point = typename Difference::Point;
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  static_assert(Difference::kIsSmooth);

  NewtonSearch(const Difference& difference, const Settings<S>& settings)
      : difference_(difference), settings_(settings), bounds_(difference, settings, difference.Inradius()) {
    const Point up = Point::Unit(L - 1);
    bounds_.SetWitness(difference.Inradius1() * up, (difference.Inradius1() - difference.Inradius()) * up);
  }

  /// Most evaluations of the support functions; what takes more has met pieces that do not fit the model.
  static constexpr int kMostIterations = 12;

  /// @param start       The first normal: ray frame, upwards.
  /// @param warm_start  Names pieces to begin with.
  /// @param observer    Called with an Iterate after each iteration.
  /// @return how the query ended; nothing if that is RayIntersection's to find out, best from the normal of the bounds
  /// on.
  template <class Observer>
  DGD_FLATTEN std::optional<Status> Solve(QueryMode mode, const Point& start, const WarmStart<S, L>* warm_start,
                                          Observer& observer) {
    if (warm_start != nullptr) RecallPieces(*warm_start);
    // Steeper ones are far from all others in these coordinates.
    Point direction = start[L - 1] > kSteep<S> ? Point(start / start[L - 1]) : Point(Point::Unit(L - 1));
    for (;;) {
      const bool has_cut = Cut(direction);
      if (iterations_ == 1 && !difference_.HasCertainInterior(highest_.support)) return std::nullopt;
      std::optional<Status> verdict = bounds_.Verdict(mode);
      const bool has_step = has_cut && !verdict && FindStep(direction);
      // Which of several pieces bound the ray is known with the step.
      if (has_step && size_ > 1) verdict = bounds_.Verdict(mode);
      Report(observer);
      if (has_cut && !verdict && (!has_step || overshoots_)) verdict = TryFaces(mode, observer);
      if (verdict) return verdict;
      if (iterations_ >= settings_.max_iterations) return Status::kIterationLimit;
      if (!has_step || iterations_ >= kMostIterations) return std::nullopt;
    }
  }

  /// What the steps have proven.
  const RayBounds<Difference>& Bounds() const { return bounds_; }
  int Iterations() const { return iterations_; }
  /// Leaves a state. That of a pair that is apart has the normal only, and where to look first.
  void Remember(Status status, WarmStart<S, L>& warm_start) const {
    warm_start.normal_1 = difference_.NormalOfSet1(bounds_.OuterDirection());
    warm_start.size = 0;
    warm_start.features_1[0] = highest_.support.feature_1;
    warm_start.features_2[0] = highest_.support.feature_2;
    if (status == Status::kSeparated) return;
    for (int i = 0; i < size_ && warm_start.size < L; ++i) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      if (i > 0 && (!piece.is_active || piece.is_fixed)) continue;
      warm_start.Add(piece.at.support.feature_1, piece.at.support.feature_2);
    }
  }

 private:
  using Feature = typename Difference::Feature;
  using Curved = CurvedDifferencePoint<S, L>;
  using Model = NewtonStepModel<S, L>;
  using Across = typename Model::Across;
  static constexpr int kMaxPieces = Model::kMaxPieces;

  struct Piece {
    Curved at;
    S height = 0;            ///< Height of its plane along the best direction, on the ray.
    bool is_fixed = false;   ///< It is a plane only: the point of another direction.
    bool is_active = false;  ///< It took part in the last step.
  };

  /// Steps without curvature begin with twice those for a ball, and grow as long as they meet nothing new. By
  /// measurement, 3.6 % of pairs of a cone and a box give up without that growth, 2.7 % with it.
  static constexpr S kDamping = S(0.5), kGrowth = S(4);
  /// What roundoff may take from a height near the minimum, where steps still bring the points nearer to the ray.
  static constexpr S kHeightSlack = 4 * kEpsilon<S>;

  /// Finds the piece of these features; null if there is none.
  Piece* FindPiece(const Feature& features, bool is_fixed) {
    const auto end = pieces_.begin() + size_;
    const auto found = std::find_if(pieces_.begin(), end, [&](const Piece& piece) {
      return piece.is_fixed == is_fixed && piece.at.support.HasFeaturesOf(features);
    });
    return found == end ? nullptr : &*found;
  }

  void RecallPieces(const WarmStart<S, L>& warm_start) {
    highest_.support.feature_1 = warm_start.features_1[0];
    highest_.support.feature_2 = warm_start.features_2[0];
    for (std::size_t i = 0; i < static_cast<std::size_t>(warm_start.size) && size_ < L; ++i) {
      Feature features;
      features.feature_1 = warm_start.features_1[i];
      features.feature_2 = warm_start.features_2[i];
      // A basis of RayIntersection has several points of a piece.
      const bool is_new = FindPiece(features, false) == nullptr;
      if (!is_new || !difference_.HasFeatures(features.feature_1, features.feature_2)) continue;
      Piece& piece = pieces_[static_cast<std::size_t>(size_++)];
      piece.at.support = features;
      piece.is_active = true;
    }
  }

  Curved SupportAlong(const Point& direction) const {
    return difference_.CurvedSupport(direction, highest_.support.feature_1, highest_.support.feature_2);
  }

  /// The highest piece along a direction (u, 1): if its plane is the lowest so far, all others follow there.
  /// @return false where a value is not finite, or too many pieces are active at once.
  bool Cut(const Point& direction) {
    ++iterations_;
    highest_ = SupportAlong(direction);
    const S height = direction.dot(highest_.support.point);
    overshoots_ = false;
    if (height <= bounds_.Outer() + kHeightSlack * bounds_.Outer()) {
      MoveTo(direction, height);
      return true;
    }
    if (!(height > 0) || bounds_.Outer() == std::numeric_limits<S>::infinity()) return false;  // Also for NaN.
    return AddPiece();
  }

  void MoveTo(const Point& direction, S height) {
    const bool is_same = size_ > 0 && pieces_[0].at.support.HasFeaturesOf(highest_.support);
    damping_ = is_same ? damping_ / kGrowth : kDamping;
    direction_ = direction;
    bounds_.LowerOuter(direction, height, highest_.support.on_1);
    // The highest one first; a place is free before each that stays.
    Piece moved{highest_, height, false, true};
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      const bool is_highest = !piece.is_fixed && piece.at.support.HasFeaturesOf(highest_.support);
      if (!piece.is_active || is_highest || kept == kMaxPieces - 1) continue;
      const Feature& features = piece.at.support;
      const Curved at =
          piece.is_fixed ? piece.at : difference_.OnFeatures(features.feature_1, features.feature_2, direction);
      const Piece next{at, direction.dot(at.support.point), piece.is_fixed, true};
      pieces_[static_cast<std::size_t>(kept++)] = moved;
      moved = next;
    }
    pieces_[static_cast<std::size_t>(kept++)] = moved;
    DGD_ASSERT(kept >= 1 && kept <= kMaxPieces);
    size_ = kept;
    if (size_ == 1) RaiseInner(highest_.support.point, highest_.support.on_1);
  }

  /// Adds what a step that went too far has met: a new piece, or the plane there of one that takes part already.
  /// @return false if there is no place for it.
  bool AddPiece() {
    overshoots_ = FindPiece(highest_.support, false) != nullptr;
    Piece* place = overshoots_ ? FindPiece(highest_.support, true) : nullptr;
    if (place == nullptr) {
      if (size_ == kMaxPieces) DropIdlePieces();
      if (size_ == kMaxPieces) return false;
      place = &pieces_[static_cast<std::size_t>(size_++)];
    }
    place->at = overshoots_
                    ? highest_
                    : difference_.OnFeatures(highest_.support.feature_1, highest_.support.feature_2, direction_);
    DGD_ASSERT(size_ <= kMaxPieces && place < pieces_.data() + size_);
    place->height = direction_.dot(place->at.support.point);
    place->is_fixed = overshoots_;
    place->is_active = true;
    return true;
  }
  void DropIdlePieces() {
    const auto end = pieces_.begin() + size_;
    const auto is_idle = [](const Piece& piece) { return !piece.is_active; };
    size_ = static_cast<int>(std::remove_if(pieces_.begin(), end, is_idle) - pieces_.begin());
  }

  /// @param direction  Out: the next one to cut along.
  bool FindStep(Point& direction) {
    Model model(bounds_.Outer(), damping_);
    typename Model::Subset guess = 0;
    for (int i = 0; i < size_; ++i) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      if (!piece.at.derivative.allFinite()) return false;
      model.Add(piece.at.support.point, piece.at.derivative, piece.height);
      guess |= unsigned{piece.is_active} << i;
    }
    if (!model.Solve(guess)) return false;
    for (int i = 0; i < size_; ++i) pieces_[static_cast<std::size_t>(i)].is_active = model.IsActive(i);
    if (size_ > 1) BoundByActive();
    direction = direction_;
    direction.template head<L - 1>() += WithinReach(model.Step());
    return true;
  }

  /// Shortens a step to where a lower plane may be: C's is not below that of the ball about the origin in C, which
  /// meets the ray at the inradius times |(u, 1)|. Without it, a first step of 35 was seen, for a cone and a box.
  Across WithinReach(const Across& step) const {
    constexpr S kPart = S(0.9);  // Only a ball has a plane as low all the way.
    const Across from = direction_.template head<L - 1>();
    const S reach = kPart * bounds_.Outer() / difference_.Inradius(), reach_sq = reach * reach - 1;
    if ((from + step).squaredNorm() <= reach_sq) return step;
    // |from + t step|^2 = reach_sq.
    const S a = step.squaredNorm(), b = step.dot(from), c = from.squaredNorm() - reach_sq;
    return c < 0 ? Across((std::sqrt(b * b - a * c) - b) / a * step) : step;
  }

  /// Tries the flat faces that may be between where a step fails, or overshoots the pieces that it is for; each once.
  template <class Observer>
  std::optional<Status> TryFaces([[maybe_unused]] QueryMode mode, [[maybe_unused]] Observer& observer) {
    if constexpr (Difference::kHasFaces) {
      const Feature features = highest_.support;
      const std::array<Point, 2> normals = {difference_.Face1(features.feature_1).normal,
                                            difference_.Face2(features.feature_2).normal};
      const std::array<FeatureId, 2> faces = {features.feature_1, features.feature_2};
      for (std::size_t i = 0; i < 2; ++i) {
        if (!(normals[i].z() > kSteep<S>) || HasTried(i, faces[i])) continue;
        if (iterations_ >= settings_.max_iterations) return std::nullopt;
        tried_faces_[i] |= FaceBit(faces[i]);
        const bool is_left = LeavesByFace(normals[i]);
        Report(observer);
        if (is_left) return bounds_.Verdict(mode);
      }
    }
    return std::nullopt;
  }
  /// The bit that stands for a face. Of faces that share one, one is tried; the shapes have two at most.
  static std::uint32_t FaceBit(FeatureId face) { return std::uint32_t{1} << face % 32; }
  bool HasTried(std::size_t set, FeatureId face) const { return (tried_faces_[set] & FaceBit(face)) != 0; }

  /// It is not inlined: rare, and long.
  DGD_NOINLINE bool LeavesByFace(const Point& normal) {
    const Point direction = normal / normal[L - 1];
    ++iterations_;
    const Curved support = SupportAlong(direction);
    const S height = direction.dot(support.support.point);
    Point on_1;
    if (!(height <= bounds_.Outer() + kHeightSlack * bounds_.Outer()) ||
        !LeavesByDisc(difference_, support.support, normal, height, on_1)) {
      return false;
    }
    bounds_.LowerOuter(direction, height, support.support.on_1);
    RaiseInner(height * Point::Unit(L - 1), on_1);
    return true;
  }

  /// Raises the inner bound by the points of the last step's pieces: by the combination of those on either side of the
  /// ray that is nearest to it.
  void BoundByActive() {
    std::array<const Feature*, L> points{};
    std::size_t count = 0;
    for (int i = 0; i < size_ && count < L; ++i) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      if (piece.is_active) points[count++] = &piece.at.support;
    }
    const auto across = [&](std::size_t i) -> Across { return points[i]->point.template head<L - 1>(); };
    std::array<S, L> weights{1};
    if (count == 2) {
      const Across side = across(1) - across(0);
      const S length_sq = side.squaredNorm();
      weights[1] = length_sq > 0 ? std::clamp(-side.dot(across(0)) / length_sq, S(0), S(1)) : S(0);
      weights[0] = 1 - weights[1];
    } else if constexpr (L == 3) {
      if (count == 3) {
        const Across a = across(0), b = across(1), c = across(2);
        const auto turn = [](const Across& from, const Across& to) { return from.x() * to.y() - from.y() * to.x(); };
        weights = {turn(b, c), turn(c, a), turn(a, b)};
        const S sum = weights[0] + weights[1] + weights[2];
        for (S& weight : weights) {
          // The ray passes beside them; also for NaN, and where they are on a line.
          if (!(weight * std::copysign(S(1), sum) >= 0 && sum != 0)) return;
          weight /= sum;
        }
      }
    }
    Point point = weights[0] * points[0]->point, on_1 = weights[0] * points[0]->on_1;
    for (std::size_t i = 1; i < count; ++i) {
      point += weights[i] * points[i]->point;
      on_1 += weights[i] * points[i]->on_1;
    }
    RaiseInner(point, on_1);
  }

  /// Raises the inner bound by a point of C off the ray: the hull of that and of C's ball about the origin contains the
  /// ray up to a height between theirs.
  /// @param on_1  The point of set 1 that it comes from.
  void RaiseInner(const Point& point, Point on_1) {
    const S inradius = difference_.Inradius();
    DGD_ASSERT(inradius > 0);
    const S distance = point.template head<L - 1>().norm();
    const S weight = inradius / (inradius + distance), height = weight * point[L - 1];
    if (!(height > bounds_.Inner())) return;
    bounds_.RaiseInner(height);
    // The ball's point is -inradius / distance times what is across the ray; its weight is distance / inradius times
    // the point's.
    on_1.template head<L - 1>() -= difference_.Inradius1() / inradius * point.template head<L - 1>();
    on_1 *= weight;
    bounds_.SetWitness(on_1, on_1 - height * Point::Unit(L - 1));
  }

  template <class Observer>
  void Report(Observer& observer) const {
    if constexpr (!std::is_same_v<Observer, const NoObserver>) {
      observer(Iterate<S, L>{iterations_, bounds_.LowerBound(), bounds_.UpperBound(), bounds_.Normal()});
    }
  }

  const Difference& difference_;
  const Settings<S>& settings_;
  RayBounds<Difference> bounds_;
  int iterations_ = 0;
  Point direction_ = Point::Unit(L - 1);  // Direction that the pieces are at: of about the lowest plane.
  Curved highest_;                        // Highest piece along the last direction.
  bool overshoots_ = false;               // The last step was too long for its pieces.
  std::array<Piece, kMaxPieces> pieces_;  // The highest along direction_ first.
  int size_ = 0;
  S damping_ = kDamping;
  std::array<std::uint32_t, 2> tried_faces_{};  // Bits of FaceBit(), of set 1 and set 2.
};

}  // namespace dgd
