// Three points of two polytopes' Minkowski difference that the ray passes between, in the world's coordinates: their
// plane, which one a new point takes the place of, and where the ray meets them. See portal_refinement.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/solver/inner_approximation.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// All lengths in metres; all points from the difference's centre. What comes after is_weighed_ is of FindPlane().
template <class S>
struct Portal {
  using Point = Vector3<S>;

  struct Corner {
    Point point;  ///< Of the cores' difference about its centre; world, metres.
    FeatureId feature_1, feature_2;
  };

  /// @param ray     From centre 1 to centre 2.
  /// @param radius  Of both sets; >= 0 where there is an answer.
  Portal(const Point& ray, S radius) : ray_(ray), radius_(radius) {}

  /// About the ray, in the ball about the centre (Alg. 1); they are no vertices.
  /// @param axis  The ray's, unit length.
  void InitialPortal(S inradius, const Point& axis) {
    constexpr S kShare1 = 1;  // Of no account: corners that are no vertices are not reported.
    const auto facet = InnerApproximation<S, 3>::FromInradius(inradius, kShare1);
    const Matrix3<S> frame = FrameAlong<S>(axis);
    for (int i = 0; i < 3; ++i) {
      corners_[static_cast<std::size_t>(i)] = {frame * facet[i].point, kNoFeature, kNoFeature};
    }
  }

  bool HasVertices() const {
    return std::ranges::none_of(corners_, [](const Corner& corner) { return corner.feature_1 == kNoFeature; });
  }

  Point NormalOfCorners() const {
    return (corners_[1].point - corners_[0].point).cross(corners_[2].point - corners_[0].point);
  }

  /// Of the corners' plane, times the normal's length; with a radius, of the plane moved by it.
  template <bool kHasRadius>
  S Height() {
    S height = normal_.dot(corners_[0].point);
    if constexpr (kHasRadius) {
      const S length = normal_.norm();
      height += radius_ * length;
      shift_ = radius_ / length * normal_;
    }
    return height;
  }

  /// Of the triangles that the new corner makes with two of the old ones, takes the one that the ray passes through.
  /// With a radius they are moved by that along the last normal, which is not quite their own: where the ray passes
  /// beside the old one, the new corner takes the place of the one across from there.
  /// @return false, and the corners as they were, where roundoff leaves none.
  template <bool kHasRadius>
  bool RefinePortal(const Corner& added) {
    if constexpr (kHasRadius) {
      const Point across = ray_.cross(added.point + shift_);
      const auto turn = [&](std::size_t i) { return across.dot(corners_[i].point + shift_); };
      if (RefinePortal(added, turn(0), turn(1), turn(2))) return true;
      FindPlane();
      const int exit_edge = FindExitEdge();
      if (exit_edge < 0) return false;
      Replace(static_cast<std::size_t>(exit_edge), added);
      return true;
    } else {
      const Point across = ray_.cross(added.point);
      const S turn_0 = across.dot(corners_[0].point), turn_1 = across.dot(corners_[1].point),
              turn_2 = across.dot(corners_[2].point);
      return RefinePortal(added, turn_0, turn_1, turn_2);
    }
  }

  /// In any place, after which the normal may have to be turned towards the ray.
  void Replace(std::size_t corner, const Corner& added) {
    DGD_ASSERT(corner < 3);
    corners_[corner] = added;
    is_weighed_ = false;
    if (NormalOfCorners().dot(ray_) < 0) std::swap(corners_[0], corners_[1]);
  }

  bool RefinePortal(const Corner& added, S turn_0, S turn_1, S turn_2) {
    if (turn_0 >= 0 && turn_1 <= 0) {
      corners_[2] = added;
    } else if (turn_1 >= 0 && turn_2 <= 0) {
      corners_[0] = added;
    } else if (turn_2 >= 0 && turn_0 <= 0) {
      corners_[1] = added;
    } else {
      return false;
    }
    is_weighed_ = false;
    return true;
  }

  /// Of the corners, towards the ray.
  void FindPlane() {
    side_1_ = corners_[1].point - corners_[0].point;
    side_2_ = corners_[2].point - corners_[0].point;
    normal_ = side_1_.cross(side_2_);
    along_ = normal_.dot(ray_);
    if (along_ < 0) {
      std::swap(corners_[1], corners_[2]);
      std::swap(side_1_, side_2_);
      normal_ = -normal_;
      along_ = -along_;
    }
    length_sq_ = normal_.squaredNorm();
    length_ = std::sqrt(length_sq_);
    height_ = normal_.dot(corners_[0].point) + radius_ * length_;
  }

  /// Whether products keep enough digits of the plane, and of weights on it. False for NaN.
  bool IsWellConditioned() const {
    const bool is_flat = along_ * along_ > kFlat * kFlat * length_sq_ * ray_.squaredNorm();
    return IsFatterThan(kFat) && is_flat && height_ > 0;
  }

  /// Finds where the ray meets the plane, by the corners' weights.
  /// @return -1 if it leaves between them, else the corner across the side that it passes beyond.
  int FindExitEdge() {
    DGD_ASSERT(!(along_ < 0) && !(length_sq_ < 0));
    exit_height_ = height_;
    weights_[1] = weights_[2] = 0;
    MoveWeights(ExitFromFirst());
    const auto least = std::ranges::min_element(weights_);
    if (*least < 0) return static_cast<int>(least - weights_.begin());
    if (!IsFatterThan(kPlain)) Refine();
    return -1;
  }

  /// Whether the ray is certain to leave between the corners, which are vertices.
  bool LeavesByFacet() {
    if (is_weighed_) return true;
    if (!HasVertices()) return false;
    FindPlane();
    return IsWellConditioned() && FindExitEdge() < 0;
  }

  /// Twice the area over the longest side's square.
  bool IsFatterThan(S share) const {
    const S longest_sq = std::max({side_1_.squaredNorm(), side_2_.squaredNorm(), (side_2_ - side_1_).squaredNorm()});
    return length_sq_ > share * share * longest_sq * longest_sq;
  }

  /// Where the ray leaves, less the radius, from the first corner.
  Point ExitFromFirst() const { return exit_height_ / along_ * ray_ - radius_ / length_ * normal_ - corners_[0].point; }

  /// @param way  On the plane.
  void MoveWeights(const Point& way) {
    weights_[1] += normal_.dot(way.cross(side_2_)) / length_sq_;
    weights_[2] += normal_.dot(side_1_.cross(way)) / length_sq_;
    weights_[0] = 1 - weights_[1] - weights_[2];
  }

  /// Of a thin triangle, the products above leave the corners' point by their weights away from where the ray leaves,
  /// by more than the corners' own roundoff: what is left between the two is taken back.
  void Refine() {
    const Point left = ExitFromFirst() - weights_[1] * side_1_ - weights_[2] * side_2_;
    const S above = normal_.dot(left);
    exit_height_ -= above;
    MoveWeights(left - above / along_ * ray_);
  }

  /// How fat a triangle must be, and the normal's cosine to the ray. By their inverses, roundoff is magnified. By
  /// measurement, of 6000 warm queries of scanned objects' hulls, growth distances are off by 4e-15 at most, relative;
  /// with five times kFat by 1e-15, in half as long again, and with a tenth of it by 2e-14.
  static constexpr S kFat = S(0.01), kFlat = S(0.05);
  /// Less fat ones are refined. Of others, the soak finds no witness point off by more than its last digit.
  static constexpr S kPlain = S(0.05);

  const Point ray_;
  const S radius_;
  std::array<Corner, 3> corners_;
  Point normal_;             // Of the corners, as long as twice the triangle's area.
  Point shift_;              // By the radius, along the normal.
  bool is_weighed_ = false;  // The ray leaves between the corners, with these weights. What follows is of them, too:
  std::array<S, 3> weights_;
  Point side_1_, side_2_;
  S along_, height_;  // Products of the normal with the ray, and with a point of the plane; with the radius.
  S exit_height_;     // The same as height_, but with the point where the ray leaves.
  S length_sq_, length_;
};

}  // namespace dgd::solver_internal
