// Growth distance and collision check against a half-space, in closed form.
//
// A half-space is unbounded, so the paper's Def. 3 needs a word on its centre: about any point of its border it looks
// the same however it is scaled. So the growth distance is the scale at which the other set alone, grown about its own
// centre, touches the half-space: the centre's height over its depth below the centre. Scaled about the foot of that
// centre, the witness points coincide as Result says.
#pragma once

#include <cmath>
#include <utility>

#include "dgd/growth_distance.h"
#include "dgd/shapes/half_space.h"

namespace dgd {

/// Set 1 against a half-space as set 2; parameters and result as for any two sets, exact up to roundoff, one iteration.
/// Where set 1's centre lies in the half-space, the growth distance is 0, kOptimal. kNoInterior if set 1 has no extent
/// across the border and its centre is above it: no scale makes them touch.
template <class Set>
requires ConvexCore<typename Set::Core> ResultOf<Set> GrowthDistance(
    const Set& set, const PoseOf<Set>& pose,
    const HalfSpace<typename Set::Scalar, kDimension<typename Set::Core>>& half_space,
    const PoseOf<Set>& half_space_pose, const Settings<typename Set::Scalar>& settings = {}) {
  using S = typename Set::Scalar;
  using Point = VectorOf<typename Set::Core>;
  const Point up = half_space_pose.rotation * half_space.Normal();
  const Point local_down = pose.rotation.transpose() * -up;
  const Point center = set.core.Center();
  const Point lowest = set.core.Support(local_down).point;
  // The height comes from the difference of the translations, so that both may be far from the world's origin.
  const S height = up.dot(pose.translation - half_space_pose.translation) - local_down.dot(center);
  const S depth = local_down.dot(lowest - center) + set.radius;

  ResultOf<Set> result;
  if (!std::isfinite(height + depth)) return result;
  result.iterations = 1;
  result.normal = -up;
  result.separation = height - depth;
  result.witness_1 = pose * lowest - set.radius * up;
  result.witness_2 = result.witness_1 - result.separation * up;
  if (height > 0 && !(depth > 0)) {
    result.status = Status::kNoInterior;
    return result;
  }
  result.lower_bound = result.upper_bound = height > 0 ? height / depth : S(0);
  result.status = result.separation > settings.separation_limit ? Status::kSeparated : Status::kOptimal;
  return result;
}

/// The same in the other order.
template <class Set>
requires ConvexCore<typename Set::Core> ResultOf<Set> GrowthDistance(
    const HalfSpace<typename Set::Scalar, kDimension<typename Set::Core>>& half_space,
    const PoseOf<Set>& half_space_pose, const Set& set, const PoseOf<Set>& pose,
    const Settings<typename Set::Scalar>& settings = {}) {
  ResultOf<Set> result = GrowthDistance(set, pose, half_space, half_space_pose, settings);
  result.normal = -result.normal;
  std::swap(result.witness_1, result.witness_2);
  return result;
}

/// Whether a set and a half-space have a point in common, exact up to roundoff: kSeparated or kColliding, never
/// kTouching; also for sets without an interior. kInvalidInput where a number is not finite.
template <class Set>
requires ConvexCore<typename Set::Core> CollisionResultOf<Set> DetectCollision(
    const Set& set, const PoseOf<Set>& pose,
    const HalfSpace<typename Set::Scalar, kDimension<typename Set::Core>>& half_space,
    const PoseOf<Set>& half_space_pose) {
  const ResultOf<Set> distance = GrowthDistance(set, pose, half_space, half_space_pose);
  CollisionResultOf<Set> result;
  if (distance.status == Status::kInvalidInput) return result;
  const bool apart = distance.separation > 0;
  result.status = apart ? Status::kSeparated : Status::kColliding;
  result.iterations = distance.iterations;
  result.normal = distance.normal;
  result.separation = distance.separation;
  result.point = apart ? (distance.witness_1 + distance.witness_2) / typename Set::Scalar(2) : distance.witness_1;
  return result;
}

/// The same in the other order.
template <class Set>
requires ConvexCore<typename Set::Core> CollisionResultOf<Set> DetectCollision(
    const HalfSpace<typename Set::Scalar, kDimension<typename Set::Core>>& half_space,
    const PoseOf<Set>& half_space_pose, const Set& set, const PoseOf<Set>& pose) {
  CollisionResultOf<Set> result = DetectCollision(set, pose, half_space, half_space_pose);
  result.normal = -result.normal;
  return result;
}

}  // namespace dgd
