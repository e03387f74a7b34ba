// Newton's step towards the lowest supporting plane of curved cores.
//
// A plane with the normal (u, 1) meets the ray at the height g(u) = s_C(u, 1), the support function of C: convex, and
// its minimum is where the ray leaves C. The features of the cores (smooth pieces and vertices) make it a maximum of
// smooth functions, g = max g_i, whose gradient is the part of the support point z_i across the ray, and whose Hessian
// is that point's derivative. The cutting plane knows of each g_i only a tangent plane at an old u. Here all of those
// that were met lately are taken at one u, and
//
//   minimise over d:  max_i (g_i + <grad g_i, d>) + 1/2 <d, H d>,   H = sum_i m_i (Hess g_i + grad g_i grad g_i^T /
//   g_i),
//
// m_i the multipliers of the pieces that are active at the minimum. This is the step of sequential quadratic
// programming for a minimax problem: one active piece gives Newton's step, as many as there are coordinates in (u, 1)
// the intersection of their tangent planes, and between these a step along the curve where two pieces are equal. It
// converges quadratically once the right pieces are known.
// The products of gradients make it the step for g^2 / 2, the squared support function, which is quadratic for a ball
// or an ellipsoid about the origin where g itself is a cone; at the minimum they vanish along the step. Far from it,
// they keep steps short.
//
// The step only names the next direction to search. The bounds take what support points say there, so that they stay
// monotone and certain whatever the step was worth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/invert.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// The model of a few pieces about one normal, and its minimum.
template <class S, int L>
class SecondOrderStep {
 public:
  using Point = Vector<S, L>;

  /// One more than are active at once, so that a newly met piece drives none of these out.
  static constexpr int kMaxPieces = L + 1;

  /// Bit i stands for the i-th added piece. As many as kMaxPieces are never active at once.
  using Subset = unsigned;

  /// @param normal  Where all pieces are taken: ray frame, unit length, upwards.
  explicit SecondOrderStep(const Point& normal) : normal_(normal) {}

  /// Adds a piece by its support point along the normal; at most kMaxPieces.
  /// @param rounding  What is kept apart of the support points' radius, metres.
  /// @return false if its plane passes through the origin, where it has no model; it is not added then.
  bool Add(const CurvedDifferencePoint<S, L>& piece, S rounding) {
    const Point on_surface = piece.support.point + rounding * normal_;
    const S height = normal_.dot(on_surface) / normal_[L - 1];
    if (height == 0) return false;
    Piece& added = pieces_[static_cast<std::size_t>(size_++)];
    added.gradient = on_surface.template head<L - 1>();
    added.height = height;
    added.hessian = normal_[L - 1] * piece.derivative + added.gradient * added.gradient.transpose() / height;
    return true;
  }

  /// Finds the step; false if there is none. Few pieces have few subsets: the minimum is where one of them is active.
  /// @param guess  Tried first.
  bool Solve(Subset guess) {
    active_ = guess;
    if (MayBeActive(guess) && IsMinimum(guess)) return true;
    for (active_ = 1; active_ < 1U << size_; ++active_) {
      if (active_ != guess && MayBeActive(active_) && IsMinimum(active_)) return true;
    }
    return false;
  }

  /// After Solve(): whether the i-th added piece is active.
  bool IsActive(int i) const { return (active_ >> i & 1U) != 0; }
  /// After Solve(): the height at which the model's plane meets the ray; metres.
  S Height() const { return height_; }
  /// After Solve(): the next normal to search, unit length.
  Point Next() const {
    Point next;
    next.template head<L - 1>() = normal_.template head<L - 1>() / normal_[L - 1] + step_;
    next[L - 1] = 1;
    return next.normalized();
  }

 private:
  static constexpr Subset kAll = (1U << kMaxPieces) - 1;
  static bool MayBeActive(Subset subset) { return subset != 0 && subset != kAll; }

  using Across = Vector<S, L - 1>;
  using Matrix = SquareMatrix<S, L - 1>;
  struct Piece {
    Across gradient;
    S height = 0;
    Matrix hessian;
  };
  /// Pieces that are taken to be equally high, and their multipliers.
  struct Members {
    std::array<const Piece*, L> pieces{};
    std::array<S, L> multipliers{};
    std::size_t size = 0;
  };

  /// Whether the model's minimum is where the pieces of the subset are equally high: none of them pulls the others
  /// down, and no other piece is higher there.
  bool IsMinimum(Subset subset) {
    Members members;
    for (std::size_t i = 0; i < Size(); ++i) {
      if ((subset >> i & 1U) != 0) members.pieces[members.size++] = &pieces_[i];
    }
    members.multipliers.fill(S(1) / S(members.size));
    // The Hessian needs the multipliers, and they need the Hessian.
    Matrix hessian;
    const int passes = members.size == 1 ? 1 : 2;
    for (int pass = 0; pass < passes; ++pass) {
      hessian.setZero();
      for (std::size_t i = 0; i < members.size; ++i) {
        hessian += std::max(members.multipliers[i], S(0)) * members.pieces[i]->hessian;
      }
      if (!Minimize(hessian, members)) return false;
    }
    if (!step_.allFinite()) return false;
    for (std::size_t i = 0; i < members.size; ++i) {
      if (!(members.multipliers[i] >= -kSqrtEpsilon<S>)) return false;
    }
    height_ = members.pieces[0]->height + members.pieces[0]->gradient.dot(step_);
    const S slack = kWeightSlack<S> * std::abs(height_);
    for (std::size_t i = 0; i < Size(); ++i) {
      const bool is_member = (subset >> i & 1U) != 0;
      if (!is_member && pieces_[i].height + pieces_[i].gradient.dot(step_) > height_ + slack) return false;
    }
    height_ += step_.dot(hessian * step_) / 2;
    return true;
  }

  /// Finds the lowest point among those where all pieces of the subset are equally high, and their multipliers there.
  /// False if there is none, or more than one: pieces that are alike, or have no curvature.
  bool Minimize(const Matrix& hessian, Members& members) {
    if (members.size == L) return IntersectPlanes(hessian, members);
    if constexpr (L == 3) {
      if (members.size == 2) return FollowLine(hessian, members);
    }
    Matrix inverse;
    if (!Invert(hessian, inverse)) return false;
    step_ = -(inverse * members.pieces[0]->gradient);
    members.multipliers[0] = 1;
    return true;
  }

  /// As many pieces as planes that meet in a point.
  bool IntersectPlanes(const Matrix& hessian, Members& members) {
    const Piece& last = *members.pieces[L - 1];
    Matrix edges;
    Across rises;
    for (int i = 0; i < L - 1; ++i) {
      const Piece& piece = *members.pieces[static_cast<std::size_t>(i)];
      edges.col(i) = piece.gradient - last.gradient;
      rises[i] = last.height - piece.height;
    }
    Matrix inverse;
    if (!Invert(edges, inverse)) return false;
    step_ = inverse.transpose() * rises;
    const Across multipliers = inverse * -(hessian * step_ + last.gradient);
    for (int i = 0; i < L - 1; ++i) members.multipliers[static_cast<std::size_t>(i)] = multipliers[i];
    members.multipliers[L - 1] = 1 - multipliers.sum();
    return true;
  }

  /// Two pieces in space: to where their planes meet, and along that line to the lowest point.
  bool FollowLine(const Matrix& hessian, Members& members) requires(L == 3) {
    const Piece &first = *members.pieces[0], &second = *members.pieces[1];
    const Across edge = first.gradient - second.gradient;
    const S length_sq = edge.squaredNorm();
    if (!(length_sq > 0)) return false;
    const Across to_line = (second.height - first.height) / length_sq * edge;
    const Across along(-edge.y(), edge.x());
    const S curvature = along.dot(hessian * along);
    if (curvature == 0) return false;
    step_ = to_line - along.dot(second.gradient + hessian * to_line) / curvature * along;
    members.multipliers[0] = -edge.dot(hessian * step_ + second.gradient) / length_sq;
    members.multipliers[1] = 1 - members.multipliers[0];
    return true;
  }

  std::size_t Size() const { return static_cast<std::size_t>(size_); }

  Point normal_;
  int size_ = 0;
  std::array<Piece, kMaxPieces> pieces_;
  Subset active_ = 0;
  Across step_ = Across::Zero();
  S height_ = 0;
};

}  // namespace dgd
