// When to take second-order steps, and on which pieces; the cutting plane is taken otherwise.
#pragma once

#include <algorithm>
#include <array>

#include "dgd/ray/flat_face.h"
#include "dgd/ray/inner_approximation.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/second_order_step.h"

namespace dgd {

/// Remembers the features of the last support points. A step starts from the best normal so far, after the bounds have
/// drawn nearer or a new piece has come up; it is not taken if its model promises what the inner approximation already
/// excludes. Measured on the paper's curved primitives, tests/bench/iterations.
template <class Difference>
class SecondOrderSearch {
 public:
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  using Point = typename Difference::Point;
  using Feature = typename Difference::Feature;

  /// @param support      Of the last direction.
  /// @param best_normal  Of the lowest supporting plane, which meets the ray at `outer_height`.
  /// @param last_gap     Of the two heights, before that direction was searched.
  /// @param inner        Takes what the pieces give along the way.
  /// @return whether there is a step, to `next`. Not inlined: it is long, and there are many pairs of types.
  [[gnu::noinline]] bool Next(const Difference& difference, const Feature& support, const Point& best_normal,
                              S outer_height, S last_outer_height, S last_gap, InnerApproximation<S, L>& inner,
                              Point& next) {
    const bool is_new = Remember(support);
    const bool is_lower = outer_height < last_outer_height;
    const bool is_good = outer_height - inner.Height() <= kProgress * last_gap;
    failures_ = is_good ? 0 : failures_ + 1;
    const bool has_start = (is_lower && (is_good || !was_taken_)) || (is_new && failures_ < kMaxFailures);
    if constexpr (Difference::kHasFaces) {
      if (!is_good && TryFace(difference, support, inner, next)) return true;
    }
    was_taken_ = has_start && Step(difference, best_normal, outer_height, inner, next);
    return was_taken_;
  }

 private:
  /// A step that leaves more of the gap is followed by a cutting plane.
  static constexpr S kProgress = S(0.9);
  /// Steps after which new pieces alone are no reason to try again.
  static constexpr int kMaxFailures = 3;
  /// Bounds what a query spends on faces that the ray does not leave through.
  static constexpr int kMaxFaceTries = 3;
  /// How far below the inner approximation a model's minimum may lie, as a part of the gap.
  static constexpr S kUndershoot = S(0.1);

  static bool AreOfSameFeatures(const Feature& a, const Feature& b) {
    return a.feature_1 == b.feature_1 && a.feature_2 == b.feature_2;
  }

  /// Not twice in a row for the same features, which may not be the highest ones along the face's normal.
  bool TryFace(const Difference& difference, const Feature& support, InnerApproximation<S, L>& inner, Point& next) {
    if (face_tries_ == kMaxFaceTries || AreOfSameFeatures(support, last_face_)) return false;
    last_face_ = support;
    ++face_tries_;
    return FindFlatFace(difference, support, inner, next);
  }

  /// @return whether the features are new; they are the first of the pieces then.
  bool Remember(const Feature& support) {
    const auto end = pieces_.begin() + count_;
    const auto found = std::find_if(pieces_.begin(), end,
                                    [&](const Piece& piece) { return AreOfSameFeatures(piece.support, support); });
    if (found != end) {
      std::rotate(pieces_.begin(), found, found + 1);
      return false;
    }
    if (count_ < static_cast<int>(pieces_.size())) ++count_;
    std::move_backward(pieces_.begin(), pieces_.begin() + count_ - 1, pieces_.begin() + count_);
    // What has just come up is most often active from now on.
    pieces_[0] = {support, true};
    return true;
  }

  /// Moves the pieces to the normal, and steps from there. The active ones go into the inner approximation, so that its
  /// points are as fresh as the normal.
  bool Step(const Difference& difference, const Point& normal, S outer_height, InnerApproximation<S, L>& inner,
            Point& next) {
    SecondOrderStep<S, L> step(normal);
    typename SecondOrderStep<S, L>::Subset guess = 0;
    for (int i = 0; i < count_; ++i) {
      auto& [support, was_active] = pieces_[static_cast<std::size_t>(i)];
      const CurvedDifferencePoint<S, L> moved = difference.FromFeatures(support.feature_1, support.feature_2, normal);
      if (!moved.derivative.allFinite()) return false;
      if (!step.Add(moved, difference.Rounding())) return false;
      support = moved.support;
      guess |= unsigned{was_active} << i;
    }
    if (!step.Solve(guess)) return false;
    for (int i = 0; i < count_; ++i) {
      auto& [support, is_active] = pieces_[static_cast<std::size_t>(i)];
      is_active = step.IsActive(i);
      if (is_active && inner.IsWorthwhile(support.point, outer_height)) inner.Insert(support, outer_height);
    }
    const S undershoot = kUndershoot * std::min(inner.Height(), outer_height - inner.Height());
    if (!(step.Height() >= inner.Height() - undershoot)) return false;
    next = step.Next();
    return true;
  }

  struct Piece {
    Feature support;
    bool is_active = false;  // Where the last step found the minimum.
  };

  std::array<Piece, SecondOrderStep<S, L>::kMaxPieces> pieces_;  // The newest first.
  Feature last_face_;                                            // The last features whose flat faces were tried.
  int face_tries_ = 0;
  int count_ = 0;
  int failures_ = 0;  // Steps and cutting planes since the last progress.
  bool was_taken_ = false;
};

}  // namespace dgd
