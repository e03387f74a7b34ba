// The Minkowski difference of two polytopes in the axes of the world, about the origin that distances are measured
// from.
//
// A search that goes on from points named by vertices most often ends after one evaluation of the support functions. So
// nothing is made ready that this does not need: the points' origins are the sets' own, and there are no centres, no
// ray and no frame along it.
#pragma once

#include <algorithm>
#include <cmath>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd::distance_internal {

/// The members of MinkowskiDifference that DistanceBounds and the searches use. Lengths in metres; points of set 1 are
/// from its own origin.
template <class Set1, class Set2>
class WorldDifference {
 public:
  using S = typename Set1::Scalar;
  static constexpr int L = 3;
  using Point = Vector3<S>;
  using Feature = DifferencePoint<S, 3>;
  static constexpr bool kHasFeatures = true, kIsSmooth = false, kIsPolytope = true;
  static_assert(MinkowskiDifference<Set1, Set2>::kIsPolytope);

  WorldDifference(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        between_(pose_2.translation - pose_1.translation),
        distance_(between_.cwiseAbs().maxCoeff()),
        convex_radius_(set_1.radius + set_2.radius) {}

  Feature Support(const Point& direction, [[maybe_unused]] const Point& normal, FeatureId hint_1,
                  FeatureId hint_2) const {
    DGD_ASSERT(IsUnitOrNan(normal));
    return Difference(SupportNear(set_1_.core, Point(pose_1_.rotation.transpose() * direction), hint_1),
                      SupportNear(set_2_.core, Point(pose_2_.rotation.transpose() * -direction), hint_2));
  }
  bool HasFeatures(FeatureId feature_1, FeatureId feature_2) const {
    return feature_1 < set_1_.core.VertexCount() && feature_2 < set_2_.core.VertexCount();
  }
  Feature FromVertices(VertexId vertex_1, VertexId vertex_2) const {
    DGD_ASSERT(HasFeatures(vertex_1, vertex_2));
    return Difference({set_1_.core.Vertex(vertex_1), vertex_1}, {set_2_.core.Vertex(vertex_2), vertex_2});
  }

  Point DistanceOrigin() const { return Point::Zero(); }
  S CenterDistance() const { return distance_; }
  S ConvexRadius() const { return convex_radius_; }
  static S Accuracy() { return 0; }
  static S Reach(const Feature& feature) {
    return std::max(feature.on_1.cwiseAbs().maxCoeff(), feature.point.cwiseAbs().maxCoeff());
  }
  Point NormalOfSet1(const Point& direction) const {
    return (pose_1_.rotation.transpose() * direction).normalized();  // Rotations in float are not quite orthogonal.
  }
  Point DirectionToWorld(const Point& direction) const { return direction; }
  Point World1(const Point& core_point, const Point& normal) const {
    return pose_1_.translation + core_point + set_1_.radius * normal;
  }
  Point World2(const Point& core_point, const Point& normal) const {
    return pose_1_.translation + core_point - set_2_.radius * normal;
  }
  /// Whether the poses are finite.
  bool IsValid() const { return std::isfinite(pose_1_.rotation.sum() + pose_2_.rotation.sum() + between_.sum()); }

 private:
  Feature Difference(const SupportPoint<S>& on_1, const SupportPoint<S>& on_2) const {
    Feature difference;
    difference.on_1.noalias() = pose_1_.rotation * on_1.point;
    difference.point.noalias() = pose_2_.rotation * on_2.point;
    difference.point = difference.on_1 - (difference.point + between_);
    difference.feature_1 = on_1.feature;
    difference.feature_2 = on_2.feature;
    return difference;
  }

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  const Point between_;  // Set 2's origin from set 1's.
  const S distance_;     // Largest coordinate of that.
  const S convex_radius_;
};

}  // namespace dgd::distance_internal
