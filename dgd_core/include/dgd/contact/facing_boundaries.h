// Two boundaries that face each other along a normal: whether they meet in one point, and whether one normal is optimal
// there (gradient.h). All by support functions alone, with the normal turned a little: so it works for all sets, in
// space and in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dgd/convex_set.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd::gradient_internal {

/// Angle by which normals are turned to see which features meet there, radians: below it, facets count as one. Far
/// above the roundoff of a normal, and of the normals of curved sets, which are as exact as the root of their gap.
template <class S>
inline constexpr S kProbeAngle = sizeof(S) == 4 ? S(1e-3) : S(6e-6);

/// Support points that move by more than this part of the sets' size while the normal turns by kProbeAngle are the ends
/// of a flat feature; less, and the surface curves, with a radius of up to half of kFlatness / kProbeAngle = 50 sizes
/// (float: 25). Test: Gradient.LargeEllipsoid_*.
template <class S>
inline constexpr S kFlatness = sizeof(S) == 4 ? S(0.05) : S(6e-4);

/// Edges within this angle are parallel, radians: what kProbeAngle resolves.
template <class S>
inline constexpr S kParallel = kProbeAngle<S>;

/// What the ray has to miss an edge of the Minkowski difference by, for the normal to be unique: as a part of the
/// coordinates that take part, for the roundoff of support points and witness points and the solver's of their sums.
template <class S>
inline constexpr S kResolution = (sizeof(S) == 4 ? 64 : 4096) * kEpsilon<S>;

/// Directions across a unit normal, as columns.
template <class S>
Eigen::Matrix<S, 3, 2> TangentsOf(const Vector<S, 3>& normal) {
  Eigen::Matrix<S, 3, 2> tangents;
  tangents.col(0) = normal.unitOrthogonal();
  tangents.col(1) = normal.cross(tangents.col(0));
  return tangents;
}
template <class S>
Eigen::Matrix<S, 2, 1> TangentsOf(const Vector<S, 2>& normal) {
  return {-normal.y(), normal.x()};
}

/// A set's boundary about its support point along the normal: where that moves to as the normal turns. World axes, from
/// the set's centre.
template <class Set>
class Boundary {
 public:
  using S = typename Set::Scalar;
  static constexpr int L = kDimension<typename Set::Core>;
  using Point = Vector<S, L>;
  using Tangent = Vector<S, L - 1>;
  using Tangents = Eigen::Matrix<S, L, L - 1>;

  /// @param side  1 for set 1, -1 for set 2, which the normal points into.
  Boundary(const Set& set, const PoseOf<Set>& pose, const Point& normal, const Tangents& tangents, S side)
      : set_(set),
        rotation_(pose.rotation),
        outwards_(side * normal),
        tangents_(tangents),
        side_(side),
        local_center_(set.core.Center()),
        center_(rotation_ * local_center_) {
    height_ = outwards_.dot(CoreSupport(outwards_)) + set.radius;
  }

  /// Centre from the pose's origin.
  const Point& Center() const { return center_; }
  /// Height of the supporting plane above the centre, metres.
  S Height() const { return height_; }
  /// How far the core reaches from its centre as seen here, metres.
  S Reach() const { return reach_; }

  /// The part across the normal of the support point along normal + kProbeAngle * turn.
  Tangent Probe(const Tangent& turn) {
    const Point along = side_ * kProbeAngle<S> * (tangents_ * turn);
    return tangents_.transpose() * (CoreSupport(outwards_ + along) + set_.radius * along);
  }

  /// The flat part of the boundary across the normal: of 0, 1 or 2 dimensions, and the direction if it is 1.
  struct FlatPart {
    int dimension = 0;
    Tangent direction = Tangent::Zero();
  };
  /// @param least_extent  Of what counts as flat, metres.
  FlatPart FindFlatPart(S least_extent) {
    Tangent longest = Width(Tangent::Unit(0));
    if constexpr (L == 3) {
      const Tangent other = Width(Tangent::Unit(1));
      if (other.squaredNorm() > longest.squaredNorm()) longest = other;
    }
    S length = longest.norm();
    if (!(length > least_extent)) return {};
    if constexpr (L == 3) {
      // The second time is along it: what the surface curves across an edge is then of second order in the angle.
      longest = Width(longest / length);
      length = longest.norm();
      if (!(length > least_extent)) return {};
      const Tangent across(-longest.y() / length, longest.x() / length);
      if (std::abs(across.dot(Width(across))) > least_extent) return {2, Tangent::Zero()};
    }
    return {1, longest / length};
  }

 private:
  Point CoreSupport(const Point& direction) {
    const Point local = rotation_.transpose() * direction;
    const Point support = rotation_ * (set_.core.Support(local).point - local_center_);
    reach_ = std::max(reach_, support.norm());
    return support;
  }
  Tangent Width(const Tangent& turn) { return Probe(turn) - Probe(-turn); }

  const Set& set_;
  const SquareMatrix<S, L> rotation_;
  const Point outwards_;
  const Tangents tangents_;
  const S side_;
  const Point local_center_, center_;
  S height_ = 0, reach_ = 0;
};

/// Two boundaries that face each other along a normal.
template <class Set1, class Set2>
struct FacingBoundaries {
  using S = typename Set1::Scalar;
  static constexpr int L = kDimension<typename Set1::Core>;
  using Point = Vector<S, L>;
  using Tangent = Vector<S, L - 1>;

  FacingBoundaries(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
                   const Point& normal)
      : tangents(TangentsOf<S>(normal)),
        boundary_1(set_1, pose_1, normal, tangents, S(1)),
        boundary_2(set_2, pose_2, normal, tangents, S(-1)),
        radii(set_1.radius + set_2.radius) {}

  /// Size of the two sets, metres.
  S Size() const { return boundary_1.Reach() + boundary_2.Reach() + radii; }

  /// Whether the flat parts of the two sets have at most one point in common, if they meet where neither ends: that
  /// leaves no direction to both of them.
  bool IsContactUnique() {
    const S least_extent = kFlatness<S> * Size();
    const auto flat_1 = boundary_1.FindFlatPart(least_extent);
    if (flat_1.dimension == 0) return true;
    const auto flat_2 = boundary_2.FindFlatPart(least_extent);
    if (flat_2.dimension == 0) return true;
    if constexpr (L == 3) {
      if (flat_1.dimension + flat_2.dimension > 2) return false;
      const Tangent &a = flat_1.direction, &b = flat_2.direction;
      return std::abs(a.x() * b.y() - a.y() * b.x()) > kParallel<S>;
    }
    return false;
  }

  /// Whether the supporting plane rises on the ray whichever way the normal turns: then no other normal is optimal.
  /// With K the points of the Minkowski difference that are met as the normal turns, seen from where the ray leaves it,
  /// the plane rises at first by <e, q(e)> when the normal turns towards e, q(e) being the support point of K: so the
  /// origin has to be inside K, by more than roundoff.
  /// @param exit       Where the ray leaves: across the normal, metres.
  /// @param tolerance  Metres.
  bool IsNormalUnique(const Tangent& exit, S tolerance) {
    const auto support = [&](const Tangent& turn) -> Tangent {
      return boundary_1.Probe(turn) - boundary_2.Probe(turn) - exit;
    };
    if constexpr (L == 2) {
      return support(Tangent(S(1)))[0] > tolerance && -support(Tangent(S(-1)))[0] > tolerance;
    } else {
      // A polygon of support points, by the angle of their directions, is refined where an edge of it is too near.
      constexpr int kMostPoints = 20;
      std::array<Tangent, kMostPoints> polygon;
      int size = 0;
      for (const Tangent& turn : {Tangent(1, 0), Tangent(0, 1), Tangent(-1, 0), Tangent(0, -1)}) {
        const Tangent point = support(turn);
        if (!(turn.dot(point) > tolerance)) return false;
        polygon[static_cast<std::size_t>(size++)] = point;
      }
      while (size < kMostPoints) {
        int nearest = 0;
        S least = std::numeric_limits<S>::infinity();
        Tangent outwards = Tangent::Zero();
        for (int i = 0; i < size; ++i) {
          const Tangent& from = polygon[static_cast<std::size_t>(i)];
          const Tangent edge = polygon[static_cast<std::size_t>(i + 1 < size ? i + 1 : 0)] - from;
          const S length = edge.norm();
          if (!(length > 0)) continue;
          const Tangent normal(edge.y() / length, -edge.x() / length);
          if (normal.dot(from) < least) {
            least = normal.dot(from);
            nearest = i;
            outwards = normal;
          }
        }
        if (least > tolerance) return true;
        const Tangent point = support(outwards);
        const S distance = outwards.dot(point);
        if (!(distance > tolerance && distance > least)) return false;
        std::move_backward(polygon.begin() + nearest + 1, polygon.begin() + size, polygon.begin() + size + 1);
        polygon[static_cast<std::size_t>(nearest + 1)] = point;
        ++size;
      }
      return false;
    }
  }

  Eigen::Matrix<S, L, L - 1> tangents;
  Boundary<Set1> boundary_1;
  Boundary<Set2> boundary_2;
  S radii;
};

}  // namespace dgd::gradient_internal
