// Newton's step towards the lowest supporting plane of curved cores.
//
// A plane with the normal (u, 1) meets the ray at the height g(u) = s_C(u, 1), the support function of C: convex, and
// its minimum is where the ray leaves C. The features of the cores (smooth pieces and vertices) make it a maximum of
// smooth functions, g = max g_i, whose gradient is the part of the support point z_i across the ray, and whose Hessian
// is that point's derivative. A cutting plane has of each g_i only a tangent plane at an old u. Here all of those that
// were met lately are taken at one u, and
//
//   minimise over d:  max_i (g_i + <grad g_i, d>) + 1/2 <d, H d>,   H = sum_i m_i (Hess g_i + grad g_i grad g_i^T / g),
//
// m_i the multipliers of the pieces that are active at the minimum. This is the step of sequential quadratic
// programming for a minimax problem: one active piece gives Newton's step, as many as there are coordinates in (u, 1)
// the intersection of their tangent planes, and between these a step along the curve where two pieces are equal. It
// converges quadratically once the right pieces are known.
// The products of gradients make it the step for g^2 / 2, the squared support function, which is quadratic for a ball
// or an ellipsoid about the origin where g itself is a cone; at the minimum they vanish along the step. Far from it,
// they keep steps short.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/invert.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// The model of a few pieces about one direction, and its minimum.
template <class S, int L>
class NewtonStepModel {
 public:
  using Point = Vector<S, L>;
  using Across = Vector<S, L - 1>;
  using Matrix = SquareMatrix<S, L - 1>;

  /// One more than are active at once, so that a newly met piece drives none of these out.
  static constexpr int kMaxPieces = L + 1;

  /// Bit i stands for the i-th added piece. As many as kMaxPieces are never active at once.
  using Subset = unsigned;

  /// @param height   Of the lowest supporting plane so far, on the ray: g; metres, > 0.
  /// @param damping  Of steps along which the pieces have no curvature, as vertices have none: with 1, they are those
  ///                 for a ball about the origin.
  NewtonStepModel(S height, S damping) : best_height_(height), damping_(damping) {}

  /// Adds a piece by its point on C, and how that moves with the direction; at most kMaxPieces. The first one is the
  /// highest.
  /// @param height  Of the point's plane on the ray.
  void Add(const Point& point, const Matrix& derivative, S height) {
    DGD_ASSERT(size_ < kMaxPieces);
    Piece& added = pieces_[static_cast<std::size_t>(size_++)];
    added.gradient = point.template head<L - 1>();
    added.height = height;
    added.hessian = derivative + added.gradient * added.gradient.transpose() / best_height_;
  }

  /// Finds the step; false if there is none. Few pieces have few subsets: the minimum is where one of them is active.
  /// @param guess  Tried first.
  bool Solve(Subset guess) {
    active_ = guess;
    if (MayBeActive(guess) && IsMinimum<false>(guess)) return true;
    return size_ > 1 && (FindMinimum<false>() || FindMinimum<true>());
  }

  /// After Solve(): whether the i-th added piece is active.
  bool IsActive(int i) const {
    DGD_ASSERT(i >= 0 && i < size_);
    return (active_ >> i & 1U) != 0;
  }
  /// After Solve(): the step across the ray, to the direction (u + step, 1).
  const Across& Step() const { return step_; }

 private:
  /// Least curvature, as a part of that of a ball about the origin as far out as the lowest plane. By measurement: with
  /// 2e-2, two of a hundred pairs of ellipsoids stretched by up to 100 creep along their flat sides; with 1e-3, none.
  static constexpr S kLeastCurvature = S(1e-4);
  /// Steps to directions that are all but across the ray are no steps: nor are there multipliers then, which overflow.
  static constexpr S kFarthest = 1 / kSqrtEpsilon<S>;
  static constexpr Subset kAll = (1U << kMaxPieces) - 1;
  static bool MayBeActive(Subset subset) { return subset != 0 && subset != kAll; }

  struct Piece {
    Across gradient;
    S height = 0;
    Matrix hessian;  ///< What the model takes for the derivative of the gradient.
  };
  /// Pieces that are taken to be equally high, and their multipliers.
  struct Members {
    std::array<const Piece*, L> pieces{};
    std::array<S, L> multipliers{};
    std::size_t size = 0;
  };

  /// @tparam kIsShared  Whether all subsets have the highest piece's Hessian. With Hessians of their own, each is
  ///                    active in another model, and there may be none whose minimum it is; with one for all, they are
  ///                    of one convex program, which has a minimum.
  template <bool kIsShared>
  DGD_NOINLINE bool FindMinimum() {
    for (active_ = 1; active_ < 1U << size_; ++active_) {
      if (MayBeActive(active_) && IsMinimum<kIsShared>(active_)) return true;
    }
    return false;
  }

  /// Whether the model's minimum is where the pieces of the subset are equally high: none of them pulls the others
  /// down, and no other piece is higher there.
  template <bool kIsShared>
  bool IsMinimum(Subset subset) {
    DGD_ASSERT(MayBeActive(subset) && subset < 1U << size_);
    Members members;
    for (std::size_t i = 0; i < Size(); ++i) {
      if ((subset >> i & 1U) != 0) members.pieces[members.size++] = &pieces_[i];
    }
    DGD_ASSERT(members.size >= 1 && members.size <= L);
    if (members.size == 1) {
      if (!Minimize(kIsShared ? pieces_[0].hessian : members.pieces[0]->hessian, members)) return false;
    } else {
      members.multipliers.fill(S(1) / S(members.size));
      // The Hessian needs the multipliers, and they need the Hessian.
      for (int pass = 0; pass < (kIsShared ? 1 : 2); ++pass) {
        if (!Minimize(kIsShared ? pieces_[0].hessian : MeanHessian(members), members)) return false;
      }
    }
    if (!step_.allFinite()) return false;
    for (std::size_t i = 0; i < members.size; ++i) {
      if (!(members.multipliers[i] >= -kSqrtEpsilon<S>)) return false;
    }
    const S height = members.pieces[0]->height + members.pieces[0]->gradient.dot(step_);
    const S slack = kWeightSlack<S> * std::abs(height);
    for (std::size_t i = 0; i < Size(); ++i) {
      const bool is_member = (subset >> i & 1U) != 0;
      if (!is_member && pieces_[i].height + pieces_[i].gradient.dot(step_) > height + slack) return false;
    }
    return true;
  }

  static Matrix MeanHessian(const Members& members) {
    Matrix hessian = Matrix::Zero();
    for (std::size_t i = 0; i < members.size; ++i) {
      hessian += std::max(members.multipliers[i], S(0)) * members.pieces[i]->hessian;
    }
    return hessian;
  }

  /// Finds the lowest point among those where all pieces of the subset are equally high, and their multipliers there.
  /// False if there is none, or more than one: pieces that are alike.
  bool Minimize(const Matrix& hessian, Members& members) {
    if (members.size == L) return IntersectPlanes(hessian, members);
    if constexpr (L == 3) {
      if (members.size == 2) return FollowLine(hessian, members);
    }
    Matrix inverse;
    if (!Invert(IsCurved(hessian) ? hessian : Matrix(hessian + damping_ * best_height_ * Matrix::Identity()),
                inverse)) {
      return false;
    }
    step_ = -(inverse * members.pieces[0]->gradient);
    members.multipliers[0] = 1;
    return true;
  }

  /// Whether a Hessian curves in every direction.
  bool IsCurved(const Matrix& hessian) const {
    const S least = kLeastCurvature * best_height_;
    if constexpr (L == 3) {
      return hessian(0, 0) * hessian(1, 1) - hessian(0, 1) * hessian(1, 0) > least * hessian.trace();
    } else {
      return hessian(0, 0) > least;
    }
  }

  /// Finds the step to the point where the planes of as many pieces meet.
  bool IntersectPlanes(const Matrix& hessian, Members& members) {
    const Piece& last = *members.pieces[L - 1];
    Across rises;
    for (int i = 0; i < L - 1; ++i) rises[i] = last.height - members.pieces[static_cast<std::size_t>(i)]->height;
    Matrix inverse;
    if (!InvertEdges(members, inverse)) return false;
    step_ = inverse.transpose() * rises;
    if (!(step_.cwiseAbs().maxCoeff() < kFarthest)) return false;
    const Across multipliers = inverse * -(hessian * step_ + last.gradient);
    for (int i = 0; i < L - 1; ++i) members.multipliers[static_cast<std::size_t>(i)] = multipliers[i];
    members.multipliers[L - 1] = 1 - multipliers.sum();
    return true;
  }

  /// @param inverse  Out: of the matrix whose columns are the gradients less the last one's.
  bool InvertEdges(const Members& members, Matrix& inverse) const {
    Matrix edges;
    for (int i = 0; i < L - 1; ++i) {
      edges.col(i) = members.pieces[static_cast<std::size_t>(i)]->gradient - members.pieces[L - 1]->gradient;
    }
    return std::abs(edges.determinant()) > (L == 3 ? Alike() * Alike() : Alike()) && Invert(edges, inverse);
  }

  /// Finds the step of two pieces in space: to where their planes meet, and along that line to the lowest point.
  bool FollowLine(const Matrix& hessian, Members& members) requires(L == 3) {
    const Piece &first = *members.pieces[0], &second = *members.pieces[1];
    const Across edge = first.gradient - second.gradient;
    const S length_sq = edge.squaredNorm();
    if (!(length_sq > Alike() * Alike())) return false;
    const Across to_line = (second.height - first.height) / length_sq * edge;
    const Across along(-edge.y(), edge.x());
    S curvature = along.dot(hessian * along);
    if (!(curvature > kLeastCurvature * best_height_ * length_sq)) curvature += damping_ * best_height_ * length_sq;
    step_ = to_line - along.dot(second.gradient + hessian * to_line) / curvature * along;
    if (!(step_.cwiseAbs().maxCoeff() < kFarthest)) return false;
    members.multipliers[0] = -edge.dot(hessian * step_ + second.gradient) / length_sq;
    members.multipliers[1] = 1 - members.multipliers[0];
    return true;
  }

  /// Gradients that differ by less are those of pieces that are alike but for roundoff; metres.
  S Alike() const { return kEpsilon<S> * best_height_; }

  std::size_t Size() const { return static_cast<std::size_t>(size_); }

  S best_height_;
  S damping_;
  int size_ = 0;
  std::array<Piece, kMaxPieces> pieces_;
  Subset active_ = 0;
  Across step_ = Across::Zero();
};

}  // namespace dgd
