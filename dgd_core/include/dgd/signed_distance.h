// The signed distance: how far two sets are apart, or the least translation that makes overlapping sets touch.
//
// The normal of the growth distance depends on the centres, but where the sets touch. This starts from it, and ends
// with the normal along which the sets are farthest apart, or overlap least.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "dgd/assert.h"
#include "dgd/distance/signed_distance_search.h"
#include "dgd/distance/world_difference.h"
#include "dgd/growth_distance.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"

namespace dgd {

/// Separation along a normal n, s(n) = min over set 2 of <n, x> - max over set 1 of <n, x>, is a lower bound of the
/// signed distance for any n, and equals it for the best one.
template <class S>
struct SignedDistanceResult {
  /// kOptimal: the bounds agree within the tolerance, or no normal nearby is better and none elsewhere by much.
  /// kStalled, kIterationLimit: they do not, and are valid all the same. kInvalidInput: no other field is usable.
  Status status = Status::kInvalidInput;
  int iterations = 0;  ///< Evaluations of the support functions.

  /// Unit vector from set 1 to set 2 in the world.
  Vector3<S> normal = Vector3<S>::UnitX();
  /// Separation along `normal`, metres, certain. Negative: moving set 2 by its absolute value along `normal` makes the
  /// sets touch.
  S separation = 0;
  /// Upper bound on the signed distance, metres: no normal separates the sets by more. For overlapping smooth sets not
  /// as sharp as `separation`, by up to a hundredth of the depth: the normal is the best nearby, and this bounds all
  /// others.
  S upper_bound = std::numeric_limits<S>::infinity();

  /// Points on set 1 and set 2, world, metres: witness_2 - witness_1 = separation * normal, within the tolerance.
  Vector3<S> witness_1 = Vector3<S>::Zero();
  Vector3<S> witness_2 = Vector3<S>::Zero();
};

namespace signed_distance_internal {
template <class S>
bool IsFinite(const SignedDistanceResult<S>& result) {
  return std::isfinite(result.normal.sum() + result.separation + result.witness_1.sum() + result.witness_2.sum());
}

/// Result of a search that ended with this status.
/// @param follow  As of SignedDistance(), or null.
template <class Search, class State>
SignedDistanceResult<typename Search::S> FoundBy(const Search& search, Status status, State* follow) {
  const auto& found = search.Found();
  SignedDistanceResult<typename Search::S> result;
  result.status = status;
  result.iterations = found.iterations;
  if (status == Status::kInvalidInput) return result;
  result.normal = found.Normal();
  result.separation = found.Separation();
  result.upper_bound = found.UpperBound();
  result.witness_1 = found.Witness1();
  result.witness_2 = found.Witness2();
  DGD_ASSERT(!(std::abs(result.normal.squaredNorm() - 1) > kSqrtEpsilon<typename Search::S>));
  if (!IsFinite(result)) {
    result.status = Status::kInvalidInput;  // A support function gave a value that is not finite.
    return result;
  }
  if (follow != nullptr) search.Remember(status, *follow);
  return result;
}
}  // namespace signed_distance_internal

/// The signed distance of two sets in space, flat ones too.
/// @param growth      Of GrowthDistance() for these sets and poses, whatever its status: the start.
/// @param warm_start  Of the same call, or nullptr; its basis saves evaluations, of curved cores up to half.
/// @param settings    relative_tolerance is of the sets' size, for curved cores: polytopes end at the roundoff of that.
///                    max_iterations bounds the evaluations.
/// @param follow      Out: where UpdateDistance() goes on from, if the result is optimal; curved cores must be apart.
///                    Not from exact contact, nor from exactly coincident boxes: there it fails.
/// Allocates nothing and does not throw. Method: distance/signed_distance_search.h.
template <class Set1, class Set2>
SignedDistanceResult<typename Set1::Scalar> SignedDistance(const Set1& set_1, const PoseOf<Set1>& pose_1,
                                                           const Set2& set_2, const PoseOf<Set1>& pose_2,
                                                           const ResultOf<Set1>& growth,
                                                           const WarmStartOf<Set1>* warm_start = nullptr,
                                                           const Settings<typename Set1::Scalar>& settings = {},
                                                           WarmStartOf<Set1>* follow = nullptr) {
  SignedDistanceSearch<MinkowskiDifference<Set1, Set2>> search(set_1, pose_1, set_2, pose_2, settings);
  const Status status = search.Solve(growth, warm_start);
  return signed_distance_internal::FoundBy(search, status, follow);
}

/// The signed distance without a growth distance: by GJK from the line of the centres to a point or a segment (the core
/// of a sphere or a capsule) and between curved cores that a plane across it separates, which takes 0.4 to 0.9 of the
/// time of the way through GrowthDistance(); in all other cases by that way.
/// @param settings, follow  As above.
/// @return as above; `iterations` includes those of the growth distance.
template <class Set1, class Set2>
SignedDistanceResult<typename Set1::Scalar> SignedDistance(const Set1& set_1, const PoseOf<Set1>& pose_1,
                                                           const Set2& set_2, const PoseOf<Set1>& pose_2,
                                                           const Settings<typename Set1::Scalar>& settings = {},
                                                           WarmStartOf<Set1>* follow = nullptr) {
  SignedDistanceSearch<MinkowskiDifference<Set1, Set2>> search(set_1, pose_1, set_2, pose_2, settings);
  const std::optional<Status> status = search.TryFromCenters();
  if (!status) {
    WarmStartOf<Set1> warm_start;
    const ResultOf<Set1> growth = GrowthDistance(set_1, pose_1, set_2, pose_2, settings, &warm_start);
    auto result = SignedDistance(set_1, pose_1, set_2, pose_2, growth, &warm_start, settings, follow);
    result.iterations += search.Found().iterations + growth.iterations;
    return result;
  }
  return signed_distance_internal::FoundBy(search, *status, follow);
}

/// The same without a growth distance, from frame to frame: of polytopes, apart or in overlap, and of curved cores that
/// stay apart, sets that overlap by less than their radii included. The face or the pair of edges that the distance is
/// at is most often the same for many frames, and costs one evaluation of the support functions: polytopes that are
/// apart take 0.3 of the time from scratch, in overlap 0.4 to 0.7 (tests/bench, shape_pairs).
/// @param state     In and out: of SignedDistance() or of the last call. Left as it was if the call fails. Curved cores
///                  need none, and take two to four times as long without; for polytopes the growth distance is the
///                  better start, and without a state this fails.
/// @param settings  As there; kSeparated is returned as soon as the sets are farther apart than separation_limit.
/// @return kOptimal, certain as SignedDistance()'s; kSeparated, with the normal and the separation along it. All other
///         statuses mean failure, and no other field is usable: SignedDistance() is to be called.
template <class Set1, class Set2>
DGD_FLATTEN SignedDistanceResult<typename Set1::Scalar> UpdateDistance(const Set1& set_1, const PoseOf<Set1>& pose_1,
                                                                       const Set2& set_2, const PoseOf<Set1>& pose_2,
                                                                       const Settings<typename Set1::Scalar>& settings,
                                                                       WarmStartOf<Set1>& state) {
  using InRayFrame = MinkowskiDifference<Set1, Set2>;
  using Difference =
      std::conditional_t<InRayFrame::kIsPolytope, distance_internal::WorldDifference<Set1, Set2>, InRayFrame>;
  SignedDistanceSearch<Difference> search(set_1, pose_1, set_2, pose_2, settings);
  const Status status = search.Update(state);
  const bool has_failed = status != Status::kOptimal && status != Status::kSeparated;
  if (!has_failed) return signed_distance_internal::FoundBy(search, status, &state);
  SignedDistanceResult<typename Set1::Scalar> result;
  result.status = status;
  result.iterations = search.Found().iterations;
  return result;
}

}  // namespace dgd
