// Newton's steps to a normal than which none nearby is better, by the smooth pieces that a search for the signed
// distance is on.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "dgd/distance/distance_bounds.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/newton_kink_step.h"
#include "dgd/inlining.h"

namespace dgd::distance_internal {

/// Up to three points of the two cores. Lengths in metres, as in DistanceBounds.
template <class S>
struct Corners {
  using Feature = DifferencePoint<S, 3>;

  Corners() = default;
  explicit Corners(const GjkSimplex<S>& simplex) : size(simplex.Size()) {
    for (std::size_t i = 0; i < size; ++i) points[i] = simplex[i];
  }

  /// Index of the point of the same pieces; size if there is none.
  std::size_t IndexOf(const Feature& point) const {
    std::size_t i = 0;
    while (i < size && !points[i].HasFeaturesOf(point)) ++i;
    return i;
  }
  /// Adds a point of other pieces, in place of the last one if there is no room.
  /// @return false if the pieces are there already.
  bool Include(const Feature& point) {
    if (IndexOf(point) < size) return false;
    points[size < points.size() ? size++ : size - 1] = point;
    return true;
  }
  /// The part of the hull that is nearest to a point, about that point.
  GjkSimplex<S> NearestTo(const Vector3<S>& target) const {
    std::array<Feature, 3> moved = points;
    for (std::size_t i = 0; i < size; ++i) moved[i].point -= target;
    return {moved, size};
  }

  std::array<Feature, 3> points;
  std::size_t size = 0;
};

/// Pieces of the two cores: their support points, each once, and what is known about them.
template <class S>
struct Pieces {
  Corners<S> support;
  PieceModels<S> models;  ///< Their weights are 0.

  /// The pieces with a point among the nearest ones, with these points' weights; of two pieces both, since the other
  /// one may have to be made level.
  PieceModels<S> Holding(const GjkSimplex<S>& nearest) const {
    PieceModels<S> holding;
    for (std::size_t i = 0; i < support.size; ++i) {
      S weight = 0;
      for (std::size_t j = 0; j < nearest.Size(); ++j) {
        if (support.points[i].HasFeaturesOf(nearest[j])) weight = nearest.Weight(j);
      }
      if (!(weight > 0) && support.size != 2) continue;
      holding[holding.size] = models[i];
      holding[holding.size++].weight = weight;
    }
    return holding;
  }
};

/// The pieces that points are on, about a normal.
template <class Bounds, class S>
Pieces<S> PiecesOf(Bounds& bounds, const Corners<S>& corners, const Vector3<S>& normal,
                   const typename Bounds::Tangents& tangents) {
  Pieces<S> pieces;
  Corners<S>& support = pieces.support;
  for (std::size_t i = 0; i < corners.size; ++i) {
    const auto& corner = corners.points[i];
    if (support.IndexOf(corner) < support.size) continue;
    const auto piece = bounds.difference.AlongTangents(corner.feature_1, corner.feature_2, normal, tangents);
    support.points[support.size++] = bounds.ToDistanceOrigin(piece.support);
    pieces.models[pieces.models.size++] = {support.points[support.size - 1].point, piece.derivative, 0};
  }
  return pieces;
}

/// A normal than which none nearby is better, but for the tolerance.
template <class Bounds>
struct LocalMinimum {
  typename Bounds::Plane plane;
  typename Bounds::Feature foot;  ///< Foot of the origin on the plane, from points of the cores.
};

/// Takes Newton's steps from the best plane, the origin inside, until the pieces that hold its foot promise no more
/// than the tolerance.
/// @param corners  Points of the pieces to begin with.
/// @return nothing if no such normal was found in a few steps.
template <class Bounds, class S = typename Bounds::S>
DGD_NOINLINE std::optional<LocalMinimum<Bounds>> FindLocalMinimum(Bounds& bounds, Corners<S> corners) {
  // Newton's steps are two to four; those against the curvature begin with so many radians, and are shortened.
  constexpr int kMaxSteps = 8;
  constexpr S kFirstReach = S(0.5), kShorter = 4;
  S reach = kFirstReach;
  for (int steps = 0; steps < kMaxSteps && !bounds.IsExhausted(); ++steps) {
    const Vector3<S> normal = bounds.best.normal;
    const S height = bounds.best.height;
    const Vector3<S> foot = height * normal;
    corners.Include(bounds.best.support);
    const typename Bounds::Tangents tangents = Bounds::TangentsAt(normal);
    const Pieces<S> pieces = PiecesOf(bounds, corners, normal, tangents);
    corners = pieces.support;
    const GjkSimplex<S> nearest = corners.NearestTo(foot);
    const PieceModels<S> holding = pieces.Holding(nearest);
    const KinkModel<S> kink(normal, tangents, holding);
    const NormalStep<S> step = StepDownKink(kink, reach, bounds.Tolerance());
    // The best plane is as high as the highest piece.
    const S gain = height - kink.Height() + step.gain;
    if (!step.is_valid || gain < -bounds.Tolerance()) return std::nullopt;
    if (gain <= bounds.Tolerance()) {
      // If not, other pieces, or points where these have no second derivative, are near the foot.
      const bool hold_foot = nearest.Nearest().squaredNorm() <= bounds.Tolerance() * bounds.size;
      if (!hold_foot) return std::nullopt;
      LocalMinimum<Bounds> minimum{bounds.best, nearest.Combination()};
      minimum.foot.point += foot;
      return minimum;
    }
    const bool is_known = !corners.Include(bounds.CutOutOfLine(step.next));
    if (is_known && !(bounds.best.height < height)) reach /= kShorter;
  }
  return std::nullopt;
}

}  // namespace dgd::distance_internal
