// Three points of two polytopes' Minkowski difference that the ray passes between, in the world's coordinates: their
// plane, which one a new point takes the place of, and where the ray meets them. See portal_refinement.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/query_types.h"
#include "dgd/solver/inner_approximation.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd::solver_internal {

/// All lengths in metres; all points from the difference's centre. FindPlane() sets what comes after is_weighed.
template <class S>
struct Portal {
  using Point = Vector3<S>;

  struct Corner {
    Point point;  ///< Point of the cores' difference about its centre; world, metres.
    FeatureId feature_1, feature_2;
  };

  /// @param from_center_1  The ray, to centre 2.
  /// @param of_both        Sum of the two sets' radii; >= 0 where the portal is refined.
  Portal(const Point& from_center_1, S of_both) : ray(from_center_1), radius(of_both) {}

  /// Puts the corners about the ray, in the ball about the centre (Alg. 1); they are no vertices.
  /// @param axis  The ray's, unit length.
  void InitialPortal(S inradius, const Point& axis) {
    constexpr S kShare1 = 1;  // It does not matter: corners that are no vertices are not reported.
    const auto facet = InnerApproximation<S, 3>::FromInradius(inradius, kShare1);
    const Matrix3<S> frame = FrameAlong<S>(axis);
    for (int i = 0; i < 3; ++i) {
      corners[static_cast<std::size_t>(i)] = {frame * facet[i].point, kNoFeature, kNoFeature};
    }
  }

  bool HasVertices() const {
    return std::ranges::none_of(corners, [](const Corner& corner) { return corner.feature_1 == kNoFeature; });
  }

  Point NormalOfCorners() const {
    return (corners[1].point - corners[0].point).cross(corners[2].point - corners[0].point);
  }

  /// Height of the corners' plane, times the normal's length; with a radius, of the plane moved by it.
  template <bool kHasRadius>
  S Height() {
    S moved = normal.dot(corners[0].point);
    if constexpr (kHasRadius) {
      const S long_as = normal.norm();
      moved += radius * long_as;
      shift = radius / long_as * normal;
    }
    return moved;
  }

  /// Takes the one of the triangles that the new corner makes with two of the old ones that the ray passes through.
  /// With a radius they are moved by that along the last normal, which is not quite their own: where the ray passes
  /// beside the old one, the new corner takes the place of the one across from there.
  /// @return false, and the corners as they were, where roundoff leaves none.
  template <bool kHasRadius>
  bool RefinePortal(const Corner& added) {
    if constexpr (kHasRadius) {
      const Point across = ray.cross(added.point + shift);
      const auto turn = [&](std::size_t i) { return across.dot(corners[i].point + shift); };
      if (RefinePortal(added, turn(0), turn(1), turn(2))) return true;
      FindPlane();
      const int exit_edge = FindExitEdge();
      if (exit_edge < 0) return false;
      Replace(static_cast<std::size_t>(exit_edge), added);
      return true;
    } else {
      const Point across = ray.cross(added.point);
      const S turn_0 = across.dot(corners[0].point), turn_1 = across.dot(corners[1].point),
              turn_2 = across.dot(corners[2].point);
      return RefinePortal(added, turn_0, turn_1, turn_2);
    }
  }

  /// Puts a corner in any place, after which the normal may have to be turned towards the ray.
  void Replace(std::size_t corner, const Corner& added) {
    DGD_ASSERT(corner < 3);
    corners[corner] = added;
    is_weighed = false;
    if (NormalOfCorners().dot(ray) < 0) std::swap(corners[0], corners[1]);
  }

  bool RefinePortal(const Corner& added, S turn_0, S turn_1, S turn_2) {
    if (turn_0 >= 0 && turn_1 <= 0) {
      corners[2] = added;
    } else if (turn_1 >= 0 && turn_2 <= 0) {
      corners[0] = added;
    } else if (turn_2 >= 0 && turn_0 <= 0) {
      corners[1] = added;
    } else {
      return false;
    }
    is_weighed = false;
    return true;
  }

  /// Finds the plane of the corners, its normal towards the ray.
  void FindPlane() {
    side_1 = corners[1].point - corners[0].point;
    side_2 = corners[2].point - corners[0].point;
    normal = side_1.cross(side_2);
    along = normal.dot(ray);
    if (along < 0) {
      std::swap(corners[1], corners[2]);
      std::swap(side_1, side_2);
      normal = -normal;
      along = -along;
    }
    length_sq = normal.squaredNorm();
    length = std::sqrt(length_sq);
    height = normal.dot(corners[0].point) + radius * length;
  }

  /// Whether products keep enough digits of the plane, and of weights on it. False for NaN.
  bool IsWellConditioned() const {
    const bool is_flat = along * along > kFlat * kFlat * length_sq * ray.squaredNorm();
    return IsFatterThan(kFat) && is_flat && height > 0;
  }

  /// Finds where the ray meets the plane, by the corners' weights.
  /// @return -1 if it leaves between them, else the corner across the side that it passes beyond.
  int FindExitEdge() {
    DGD_ASSERT(!(along < 0) && !(length_sq < 0));
    exit_height = height;
    weights[1] = weights[2] = 0;
    MoveWeights(ExitFromFirst());
    const auto least = std::ranges::min_element(weights);
    if (*least < 0) return static_cast<int>(least - weights.begin());
    if (!IsFatterThan(kPlain)) Refine();
    return -1;
  }

  /// Whether the ray is certain to leave between the corners, which are vertices.
  bool LeavesByFacet() {
    if (is_weighed) return true;
    if (!HasVertices()) return false;
    FindPlane();
    return IsWellConditioned() && FindExitEdge() < 0;
  }
  /// Whether the ray ends below the corners, moved by the radius, and between them. With a radius they may be turned
  /// away from the ray, and their plane, moved, is no bound then.
  /// @param ray_end, plane  Products of the normal with the ray, and with the moved plane's points.
  bool EndsBelow(S ray_end, S plane) { return ray_end > 0 && ray_end <= plane && LeavesByFacet(); }

  /// The vertices of one core by the corners' weights, in the core's frame.
  template <class Core>
  Point Combine(const Core& core, FeatureId Corner::*feature) const {
    DGD_ASSERT(HasVertices());
    Point sum = weights[0] * core.Vertex(corners[0].*feature);
    for (std::size_t i = 1; i < 3; ++i) sum += weights[i] * core.Vertex(corners[i].*feature);
    return sum;
  }

  /// Leaves the features of the corners for another query.
  void Leave(WarmStart<S>& state) const {
    for (std::size_t i = 0; i < 3; ++i) {
      state.features_1[i] = corners[i].feature_1;
      state.features_2[i] = corners[i].feature_2;
    }
  }

  /// Whether twice the area is more than a part of the longest side's square.
  bool IsFatterThan(S share) const {
    const S longest_sq = std::max({side_1.squaredNorm(), side_2.squaredNorm(), (side_2 - side_1).squaredNorm()});
    return length_sq > share * share * longest_sq * longest_sq;
  }

  /// Point where the ray leaves, less the radius, from the first corner.
  Point ExitFromFirst() const { return exit_height / along * ray - radius / length * normal - corners[0].point; }

  /// @param way  On the plane.
  void MoveWeights(const Point& way) {
    weights[1] += normal.dot(way.cross(side_2)) / length_sq;
    weights[2] += normal.dot(side_1.cross(way)) / length_sq;
    weights[0] = 1 - weights[1] - weights[2];
  }

  /// Corrects the weights of a thin triangle. The products above leave the corners' point by their weights away from
  /// where the ray leaves, by more than the corners' own roundoff: what is left between the two is taken back.
  void Refine() {
    const Point left = ExitFromFirst() - weights[1] * side_1 - weights[2] * side_2;
    const S above = normal.dot(left);
    exit_height -= above;
    MoveWeights(left - above / along * ray);
  }

  /// How fat a triangle must be, and the normal's cosine to the ray. By their inverses, roundoff is magnified. By
  /// measurement, of 6000 warm queries of scanned objects' hulls, growth distances are off by 4e-15 at most, relative;
  /// with five times kFat by 1e-15, in half as long again, and with a tenth of it by 2e-14.
  static constexpr S kFat = S(0.01), kFlat = S(0.05);
  /// Less fat ones are refined. Of others, the soak finds no witness point off by more than its last digit.
  static constexpr S kPlain = S(0.05);

  const Point ray;
  const S radius;
  std::array<Corner, 3> corners;
  Point normal;             ///< Normal of the corners' plane, as long as twice the triangle's area.
  Point shift;              ///< Way of the plane by the radius, along the normal.
  bool is_weighed = false;  ///< The ray leaves between the corners, with these weights and by the plane that follows.
  std::array<S, 3> weights;
  Point side_1, side_2;
  S along, height;  ///< Products of the normal with the ray, and with a point of the plane; with the radius.
  S exit_height;    ///< The same as height, but with the point where the ray leaves.
  S length_sq, length;
};

}  // namespace dgd::solver_internal
