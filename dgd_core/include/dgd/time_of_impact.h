// When two moving sets touch first: a sweep that is never late.
//
// The growth distance at one moment brings a plane between the sets; sweep/plane_sweep.h proves how long that plane
// keeps them apart; there the next plane is found. At contact the growth distance's normal is the contact's own, so the
// planes close in on the impact as Newton's method does, and for polytopes that do not turn they end after finitely
// many.
#pragma once

#include "dgd/assert.h"
#include "dgd/growth_distance.h"
#include "dgd/motion.h"
#include "dgd/signed_distance.h"
#include "dgd/sweep/plane_sweep.h"

namespace dgd {

/// When a sweep ends.
template <class S>
struct SweepSettings {
  /// Sets nearer than this touch; metres, > 0. The default is some hundred times what roundoff leaves of coordinates of
  /// a few metres; with larger ones, it must be raised.
  S tolerance = sizeof(S) == 8 ? S(1e-10) : S(1e-5);
  /// Sets that overlap by no more than this do not touch yet; metres, >= 0. Bodies that lie on each other may so slide
  /// past what is flush with their support but for roundoff.
  S allowed_overlap = 0;
  int max_planes = 100;  ///< Most planes to try; >= 1.
};

/// When and where two moving sets touch first.
template <class S>
struct TimeOfImpactResult {
  /// kTouching: at `time` the sets touch within the tolerance. kColliding: they overlap from the start. kSeparated:
  /// they never touch. kIterationLimit, kStalled: what happens after `time` is not known; that they do not touch before
  /// is as certain as ever. kInvalidInput: no other field is usable.
  Status status = Status::kInvalidInput;
  int planes = 0;      ///< Tried, each at the cost of a growth distance.
  int iterations = 0;  ///< Evaluations of the support functions: for planes, and for how long these last.

  /// A time in [0, 1]: at no earlier one do the sets touch.
  S time = 0;
  /// Unit normal from set 1 to set 2 at that time (kSeparated: at the last plane's), the separation along it, and a
  /// point of either set that are so far apart. World, metres.
  Vector3<S> normal = Vector3<S>::UnitX();
  S separation = 0;
  Vector3<S> witness_1 = Vector3<S>::Zero();
  Vector3<S> witness_2 = Vector3<S>::Zero();
};

/// Relative tolerance of a growth distance that serves for its plane alone, which is the sets' own at impact: what
/// roundoff lets be proven.
template <class S>
inline constexpr S kPlaneTolerance = 1024 * kEpsilon<S>;

/// Whether such a growth distance brings no plane between the sets and does not show that they overlap either: they
/// have no interior, or roundoff keeps the bounds apart. The signed distance decides then.
template <class S>
bool IsUndecided(const Result<S>& growth) {
  return growth.status != Status::kInvalidInput && !(growth.separation > 0 || growth.upper_bound <= 1);
}

/// The plane between two sets that the growth distance brings, as far as Result's status, normal, separation and
/// witness points go; the signed distance's where that brings none.
template <class S, class Set1, class Set2>
Result<S> PlaneBetween(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
                       WarmStart<S>& warm_start) {
  Settings<S> settings;
  settings.relative_tolerance = kPlaneTolerance<S>;
  Result<S> result = GrowthDistance(set_1, pose_1, set_2, pose_2, settings, &warm_start);
  if (!IsUndecided(result)) return result;
  const SignedDistanceResult<S> distance = SignedDistance(set_1, pose_1, set_2, pose_2, result, &warm_start, settings);
  result.status = distance.status;
  result.iterations += distance.iterations;
  result.normal = distance.normal;
  result.separation = distance.separation;
  result.witness_1 = distance.witness_1;
  result.witness_2 = distance.witness_2;
  return result;
}

/// When two moving sets touch first.
/// @param plane_between  Called with two poses, for a plane between the sets there, as a Result of which status (only
///                       whether it is kInvalidInput), iterations, normal, separation and witness points are read: how
///                       it is found, is the caller's choice.
/// Allocates nothing and does not throw.
template <class Set1, class Set2, class Ask>
TimeOfImpactResult<typename Set1::Scalar> TimeOfImpact(const Set1& set_1, const Motion<typename Set1::Scalar>& motion_1,
                                                       const Set2& set_2, const Motion<typename Set1::Scalar>& motion_2,
                                                       const SweepSettings<typename Set1::Scalar>& settings,
                                                       Ask&& plane_between) {
  using S = typename Set1::Scalar;
  DGD_ASSERT(settings.tolerance > 0 && settings.max_planes >= 1);
  TimeOfImpactResult<S> result;
  if (!motion_1.IsFinite() || !motion_2.IsFinite()) return result;
  PlaneSweep<Set1, Set2> sweep(set_1, motion_1, set_2, motion_2, settings.allowed_overlap);
  result.status = Status::kIterationLimit;
  while (result.planes < settings.max_planes) {
    const Result<S> plane = plane_between(motion_1.At(result.time), motion_2.At(result.time));
    if (plane.status == Status::kInvalidInput) return {};
    ++result.planes;
    result.iterations += plane.iterations;
    result.normal = plane.normal;
    result.separation = plane.separation;
    result.witness_1 = plane.witness_1;
    result.witness_2 = plane.witness_2;
    const S clearance = plane.separation + settings.allowed_overlap;
    if (!(clearance > settings.tolerance)) {
      const bool from_start = result.time == 0 && clearance < -settings.tolerance;
      result.status = from_start ? Status::kColliding : Status::kTouching;
      break;
    }
    const S time = sweep.KeepsApartUntil(plane.normal, result.time, settings.tolerance);
    if (!(time < 1)) {
      result.status = Status::kSeparated;
      result.time = 1;
      break;
    }
    if (!(time > result.time)) {
      // The sweep, which moves the sets in its own way, may see them just within the tolerance.
      const bool touches = sweep.SeparationAt(plane.normal, time) <= settings.tolerance;
      result.status = touches ? Status::kTouching : Status::kStalled;
      break;
    }
    DGD_ASSERT(time > result.time && time < 1);
    result.time = time;
  }
  result.iterations += sweep.Evaluations();
  return result;
}

template <class Set1, class Set2>
TimeOfImpactResult<typename Set1::Scalar> TimeOfImpact(const Set1& set_1, const Motion<typename Set1::Scalar>& motion_1,
                                                       const Set2& set_2, const Motion<typename Set1::Scalar>& motion_2,
                                                       const SweepSettings<typename Set1::Scalar>& settings = {}) {
  WarmStartOf<Set1> warm_start;
  return TimeOfImpact(set_1, motion_1, set_2, motion_2, settings,
                      [&](const PoseOf<Set1>& pose_1, const PoseOf<Set1>& pose_2) {
                        return PlaneBetween(set_1, pose_1, set_2, pose_2, warm_start);
                      });
}

}  // namespace dgd
