// The smooth pieces that a search for the signed distance is on, and the normal than which none nearby is better.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "dgd/distance/gjk_simplex.h"
#include "dgd/distance/newton_kink_step.h"
#include "dgd/distance/newton_step.h"
#include "dgd/distance/plane_search.h"
#include "dgd/inlining.h"

namespace dgd::distance_internal {

/// Lengths in metres, in the ray's frame, as in PlaneSearch.
template <class Set1, class Set2>
class PieceSearch : protected PlaneSearch<Set1, Set2> {
  using Planes = PlaneSearch<Set1, Set2>;

 public:
  using Planes::Planes;
  using typename Planes::Difference;
  using typename Planes::Feature;
  using typename Planes::Point;
  using typename Planes::S;

 protected:
  using Planes::best_;
  using Planes::Cut;
  using Planes::difference_;
  using Planes::is_news_;
  using Planes::IsExhausted;
  using Planes::size_;
  using Planes::TangentsAt;
  using Planes::ToDistanceOrigin;
  using Planes::Tolerance;
  using typename Planes::Plane;
  using typename Planes::Tangents;

  /// Up to three points of the two cores.
  struct Corners {
    std::array<Feature, 3> points;
    std::size_t size = 0;

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
  };

  static Corners CornersOf(const GjkSimplex<S>& simplex) {
    Corners corners;
    for (; corners.size < simplex.Size(); ++corners.size) corners.points[corners.size] = simplex[corners.size];
    return corners;
  }

  /// Pieces of the two cores: their support points, each once, and what is known about them.
  struct Pieces {
    Corners support;
    PieceModels<S> models;  ///< With weights of 0.
  };

  /// The pieces that points are on, about a normal.
  Pieces PiecesOf(const Corners& corners, const Point& normal,
                  const Tangents& tangents) requires(Difference::kIsSmooth) {
    Pieces pieces;
    Corners& support = pieces.support;
    for (std::size_t i = 0; i < corners.size; ++i) {
      const Feature& corner = corners.points[i];
      if (support.IndexOf(corner) < support.size) continue;
      const auto piece = difference_.AlongTangents(corner.feature_1, corner.feature_2, normal, tangents);
      support.points[support.size++] = ToDistanceOrigin(piece.support);
      pieces.models[pieces.models.size++] = {support.points[support.size - 1].point, piece.derivative, 0};
    }
    return pieces;
  }

  /// A normal than which none nearby is better, but for the tolerance.
  struct LocalMinimum {
    Plane plane;
    Feature foot;  ///< Of the origin on the plane, from points of the cores.
  };

  /// With the origin inside: Newton's steps from the best plane, until the pieces that hold its foot promise no more
  /// than the tolerance.
  /// @param corners  Points of the pieces to begin with.
  /// @return nothing if no such normal was found in a few steps.
  DGD_NOINLINE std::optional<LocalMinimum> Descend(Corners corners) requires(Difference::kIsSmooth) {
    S reach = kFirstReach;
    for (int steps = 0; steps < kMaxSteps && !IsExhausted(); ++steps) {
      const Point normal = best_.normal;
      const S height = best_.height;
      const Point foot = height * normal;
      corners.Include(best_.support);
      const Tangents tangents = TangentsAt(normal);
      const Pieces pieces = PiecesOf(corners, normal, tangents);
      corners = pieces.support;
      const GjkSimplex<S> nearest = HullAbout(foot, corners);
      const PieceModels<S> holding = HoldingPieces(pieces, nearest);
      const KinkModel<S> kink(normal, tangents, holding);
      const NormalStep<S> step = StepDownKink(kink, reach, Tolerance());
      // Of the best plane, which is as high as the highest piece.
      const S gain = height - kink.Height() + step.gain;
      if (!step.is_valid || gain < -Tolerance()) return std::nullopt;
      if (gain <= Tolerance()) {
        // Else other pieces, or points where these have no second derivative, are near the foot.
        const bool hold_foot = nearest.Nearest().squaredNorm() <= Tolerance() * size_;
        if (!hold_foot) return std::nullopt;
        is_news_ = false;
        LocalMinimum minimum{best_, nearest.Combination()};
        minimum.foot.point += foot;
        return minimum;
      }
      const bool is_known = !corners.Include(Cut(step.next));
      if (is_known && !(best_.height < height)) reach /= kShorter;
    }
    return std::nullopt;
  }

 private:
  /// What of the corners' hull is nearest to a point, about that point.
  static GjkSimplex<S> HullAbout(const Point& target, Corners corners) {
    for (std::size_t i = 0; i < corners.size; ++i) corners.points[i].point -= target;
    return {corners.points, corners.size};
  }

  /// The pieces with a point among the nearest ones, with these points' weights; of two pieces both, since the other
  /// one may have to be made level.
  static PieceModels<S> HoldingPieces(const Pieces& pieces, const GjkSimplex<S>& nearest) {
    PieceModels<S> holding;
    const Corners& support = pieces.support;
    for (std::size_t i = 0; i < support.size; ++i) {
      S weight = 0;
      for (std::size_t j = 0; j < nearest.Size(); ++j) {
        if (support.points[i].HasFeaturesOf(nearest[j])) weight = nearest.Weight(j);
      }
      if (!(weight > 0) && support.size != 2) continue;
      holding[holding.size] = pieces.models[i];
      holding[holding.size++].weight = weight;
    }
    return holding;
  }

  /// Newton's steps are two to four; those against the curvature begin with so many radians, and are shortened.
  static constexpr int kMaxSteps = 8;
  static constexpr S kFirstReach = S(0.5), kShorter = 4;
};

}  // namespace dgd::distance_internal
