// The queries that growth_distance.h declares, step by step: the last separating axis, portal refinement of polytopes,
// Newton's steps of curved sets, and the ray intersection for all that these leave.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "dgd/assert.h"
#include "dgd/growth_distance.h"
#include "dgd/inlining.h"
#include "dgd/solver/ball_hull.h"
#include "dgd/solver/first_normal.h"
#include "dgd/solver/newton.h"
#include "dgd/solver/portal_refinement.h"
#include "dgd/solver/ray_intersection.h"

namespace dgd {

/// Whether the last query found the sets apart, and its normal is the first one to try.
template <class S, int L>
bool HasSeparatingAxis(const WarmStart<S, L>* warm_start) {
  return warm_start != nullptr && warm_start->size == 0 && HasNormal(*warm_start);
}

/// The supporting planes of two sets across one direction, before any frame is made.
template <class Set>
struct SupportingPlanes {
  using S = typename Set::Scalar;
  using Point = VectorOf<typename Set::Core>;
  using Support = SupportPoint<S, kDimension<typename Set::Core>>;

  Point normal;                  ///< World, unit length, from set 1 to set 2.
  Support support_1, support_2;  ///< Support points of the cores, in their frames.
  S separation;                  ///< Metres, negative for overlap.
};

/// Evaluates each set's support function along one direction.
/// @param normal_1  Unit length, set 1's frame.
template <class Set1, class Set2>
DGD_FLATTEN SupportingPlanes<Set1> PlanesAlong(const VectorOf<typename Set1::Core>& normal_1, const Set1& set_1,
                                               const PoseOf<Set1>& pose_1, const Set2& set_2,
                                               const PoseOf<Set1>& pose_2) {
  SupportingPlanes<Set1> planes;
  planes.normal = pose_1.rotation * normal_1;
  const VectorOf<typename Set1::Core> normal_2 = pose_2.rotation.transpose() * -planes.normal;
  planes.support_1 = set_1.core.Support(normal_1);
  planes.support_2 = set_2.core.Support(normal_2);
  planes.separation = planes.normal.dot(pose_2.translation - pose_1.translation) -
                      normal_1.dot(planes.support_1.point) - normal_2.dot(planes.support_2.point) - set_1.radius -
                      set_2.radius;
  return planes;
}

/// Whether the planes part the sets by more than `limit`: so two evaluations of support functions and a few dot
/// products decide most pairs of a broadphase, which are apart and stay so.
template <class Set>
bool SeparateByMoreThan(const SupportingPlanes<Set>& planes, typename Set::Scalar limit) {
  return planes.separation > limit && std::isfinite(planes.separation);  // False for NaN.
}

/// Whether sets overlap for certain, by the ball about their difference's centre and by its point farthest along the
/// planes' normal.
/// @param result  Set if so.
template <class Set1, class Set2>
DGD_FLATTEN bool OverlapAboutCenters(const SupportingPlanes<Set1>& planes, const Set1& set_1,
                                     const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
                                     CollisionResultOf<Set1>& result) {
  using S = typename Set1::Scalar;
  using Point = VectorOf<typename Set1::Core>;
  if (!HasCertainInterior(set_1, set_2, planes.support_1.point, planes.support_2.point)) return false;
  const Point center_1 = pose_1.rotation * set_1.core.Center(), center_2 = pose_2.rotation * set_2.core.Center();
  const Point ray = (pose_2.translation - pose_1.translation) + (center_2 - center_1);
  const Point top_1 = pose_1.rotation * planes.support_1.point - center_1 + set_1.radius * planes.normal;
  const Point top_2 = pose_2.rotation * planes.support_2.point - center_2 - set_2.radius * planes.normal;
  const S inradius_1 = set_1.core.Inradius() + set_1.radius;
  const S inradius = inradius_1 + set_2.core.Inradius() + set_2.radius;
  const auto end = solver_internal::FindInBallHull(ray, Point(top_1 - top_2), inradius);
  if (!end) return false;
  result.status = Status::kColliding;
  result.iterations = 1;
  result.point = pose_1.translation + center_1 + end->share * top_1 + inradius_1 / inradius * end->inside;
  return true;
}

/// Decides a collision check by the planes along one direction: they separate the sets, or the overlap about the
/// centres is certain.
/// @param result  Set if so.
/// @return whether it is decided.
template <class Set1, class Set2>
bool ClassifyByPlane(const SupportingPlanes<Set1>& planes, const Set1& set_1, const PoseOf<Set1>& pose_1,
                     const Set2& set_2, const PoseOf<Set1>& pose_2, CollisionResultOf<Set1>& result) {
  if (!SeparateByMoreThan(planes, typename Set1::Scalar(0))) {
    return OverlapAboutCenters(planes, set_1, pose_1, set_2, pose_2, result);
  }
  result.status = Status::kSeparated;
  result.iterations = 1;
  result.normal = planes.normal;
  result.separation = planes.separation;
  result.point = pose_1 * planes.support_1.point + (set_1.radius + planes.separation / 2) * planes.normal;
  return true;
}

/// Finds the direction from centre to centre, which is the first one of a cold query.
/// @param normal_1  Out: unit length, set 1's frame.
/// @return false for coincident centres, for sets without an interior, and for sizes out of range.
template <class Set1, class Set2>
bool FindLineOfCenters(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
                       VectorOf<typename Set1::Core>& normal_1) {
  using S = typename Set1::Scalar;
  using Point = VectorOf<typename Set1::Core>;
  const S inradius = set_1.core.Inradius() + set_2.core.Inradius() + set_1.radius + set_2.radius;
  if (!(inradius > 0)) return false;
  const Point between_centers = pose_2 * set_2.core.Center() - pose_1 * set_1.core.Center();
  const S distance = between_centers.norm();
  if (!(distance > 0 && IsInRange(distance, inradius))) return false;
  normal_1 = pose_1.rotation.transpose() * Point(between_centers / distance);
  return true;
}

/// Whether PortalRefinement is for these sets.
template <class Set1, class Set2>
constexpr bool kHasPortalRefinement =
    kDimension<typename Set1::Core> == 3 && MinkowskiDifference<Set1, Set2>::kIsPolytope;

/// Portal refinement: warm from the last facet, if there is one, else cold. Not inlined: with its registers, sets that
/// stay apart take 15 ns longer.
/// @param first      The planes along the line of centres, or null if they are not known.
/// @param result     Out, if it is solved.
/// @param remaining  Out: the settings of what is left to do, if it is not.
/// @return whether it is solved.
template <class Set1, class Set2, class AnyResult>
DGD_FLATTEN DGD_NOINLINE bool SolveByPortal(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                            const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings,
                                            WarmStartOf<Set1>* warm_start,
                                            std::type_identity_t<const SupportingPlanes<Set1>*> first,
                                            AnyResult& result, Settings<typename Set1::Scalar>& remaining) {
  using Refinement = PortalRefinement<Set1, Set2>;
  if (settings.max_iterations <= Refinement::kMaxColdSteps) return false;
  Refinement refinement(set_1, pose_1, set_2, pose_2);
  if (first != nullptr) refinement.StartFrom(first->support_1, first->support_2);
  // RayIntersection goes on from an edge or a corner, and from a thin facet, at which a cold start would end, too.
  const int size = warm_start != nullptr ? warm_start->size : 0;
  if (size == 3 && refinement.SolveWarm(settings, *warm_start, result)) return true;
  const bool has_left_facet = size == 3 && refinement.HasFastColdStart() && !refinement.EndedAtThinFacet();
  if ((size == 0 || has_left_facet) && refinement.SolveCold(settings, warm_start, result)) return true;
  result = {};
  remaining.max_iterations -= refinement.Iterations();
  return false;
}

/// Writes the result of a query in the ray's frame.
template <class Difference, class S, int L>
void Report(const Difference&, const RayBounds<Difference>& bounds, Status status, Result<S, L>& result) {
  result.status = status;
  result.lower_bound = bounds.LowerBound();
  result.upper_bound = bounds.UpperBound();
  result.normal = bounds.Normal();
  result.separation = bounds.Separation();
  result.witness_1 = bounds.Witness1();
  result.witness_2 = bounds.Witness2();
  DGD_ASSERT(!(result.lower_bound > result.upper_bound));
  DGD_ASSERT(!(std::abs(result.normal.squaredNorm() - 1) > kSqrtEpsilon<S>));
}
template <class Difference, class S, int L>
void Report(const Difference& difference, const RayBounds<Difference>& bounds, Status status,
            CollisionResult<S, L>& result) {
  result.status = status;
  switch (status) {
    case Status::kSeparated:
      result.normal = bounds.Normal();
      result.separation = bounds.Separation();
      result.point = bounds.PointBetween();
      break;
    case Status::kCoincidentCenters:
      result.status = Status::kColliding;
      [[fallthrough]];
    case Status::kColliding:
    case Status::kTouching:
      // Where the witness points meet when the sets are scaled by the upper bound about their centres: a point of both
      // sets if that is at most 1.
      result.point = difference.Center1() + bounds.UpperBound() * (bounds.Witness1() - difference.Center1());
      break;
    default:
      break;
  }
}

/// Takes the bounds of a search that has given up where they are better. Where roundoff puts the two in the wrong
/// order, the upper one stays, as it does in each part of a query.
/// @param bounds  A result or an iterate.
/// @return for each bound whether it is the search's now, the lower one first.
template <class Search, class Bounds>
std::pair<bool, bool> MergeBoundsOf(const Search& search, Bounds& bounds) {
  const bool has_lower = search.LowerBound() > bounds.lower_bound, has_upper = search.UpperBound() < bounds.upper_bound;
  if (has_lower) {
    bounds.lower_bound = search.LowerBound();
    bounds.normal = search.Normal();
  }
  if (has_upper) bounds.upper_bound = search.UpperBound();
  bounds.lower_bound = std::min(bounds.lower_bound, bounds.upper_bound);
  return {has_lower, has_upper};
}
template <class Search, class S, int L>
void MergeBounds(const Search& search, Result<S, L>& result) {
  const auto [has_lower, has_upper] = MergeBoundsOf(search, result);
  if (has_lower) result.separation = search.Separation();
  if (has_upper) {
    result.witness_1 = search.Witness1();
    result.witness_2 = search.Witness2();
  }
}
/// A collision check has no bounds.
template <class Search, class S, int L>
void MergeBounds(const Search&, CollisionResult<S, L>&) {}

/// The ray intersection (Alg. 3).
/// @param settings  Of what is left to do.
/// @param result    In: the iterations done.
template <class Set1, class Set2, class Observer, class AnyResult>
void SolveByRayIntersection(QueryMode mode, const MinkowskiDifference<Set1, Set2>& difference,
                            const Settings<typename Set1::Scalar>& settings, WarmStartOf<Set1>* warm_start,
                            Observer& observer, AnyResult& result) {
  RayIntersection<Set1, Set2> query(difference, settings);
  const Status status = query.Solve(mode, warm_start, observer);
  if (status == Status::kNoInterior) {
    result = {};
    result.status = status;
    return;
  }
  result.iterations += query.Iterations();
  Report(difference, query.Bounds(), status, result);
}

/// The ray intersection from where Newton's steps give up, having met pieces too far from the optimum to fit their
/// model: from the best normal so far. Not inlined: rare, and long.
/// @param search    The steps.
/// @param settings  Those that the steps began with.
template <class Set1, class Set2, class Observer, class AnyResult>
DGD_NOINLINE void SolveAfterNewton(QueryMode mode, const NewtonSearch<Set1, Set2>& search,
                                   const MinkowskiDifference<Set1, Set2>& difference,
                                   Settings<typename Set1::Scalar> settings, WarmStartOf<Set1>* warm_start,
                                   Observer& observer, AnyResult& result) {
  WarmStartOf<Set1> own_state;
  WarmStartOf<Set1>& state = warm_start != nullptr ? *warm_start : own_state;
  state = {};
  state.normal_1 = difference.NormalOfSet1(search.Bounds().NormalInFrame());
  settings.max_iterations -= search.Iterations();
  if constexpr (std::is_same_v<Observer, const NoObserver>) {
    SolveByRayIntersection(mode, difference, settings, &state, observer, result);
  } else {
    // The iterates are counted on, and have the better of both bounds.
    const auto going_on = [&](auto iterate) {
      iterate.iteration += search.Iterations();
      MergeBoundsOf(search.Bounds(), iterate);
      observer(iterate);
    };
    SolveByRayIntersection(mode, difference, settings, &state, going_on, result);
  }
  if (result.status != Status::kNoInterior) MergeBounds(search.Bounds(), result);
}

/// Solves in the ray's frame: curved sets by Newton's steps, and by the ray intersection where these end; others by the
/// ray intersection.
/// @param settings  Of what is left to do.
/// @param result    In: the iterations done.
template <class Set1, class Set2, class Observer, class AnyResult>
DGD_FLATTEN void SolveInRayFrame(QueryMode mode, const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                 const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings,
                                 WarmStartOf<Set1>* warm_start, Observer& observer, AnyResult& result) {
  using Difference = MinkowskiDifference<Set1, Set2>;
  const Difference difference(set_1, pose_1, set_2, pose_2);
  if (!difference.IsValid()) {
    result = {};
    return;
  }
  if constexpr (Difference::kIsSmooth) {
    if (difference.HasRay()) {
      NewtonSearch<Set1, Set2> search(difference, settings);
      const auto status = search.Solve(mode, FirstNormal(difference, warm_start), warm_start, observer);
      result.iterations += search.Iterations();
      if (!status) return SolveAfterNewton(mode, search, difference, settings, warm_start, observer, result);
      if (warm_start != nullptr) search.Remember(*status, *warm_start);
      return Report(difference, search.Bounds(), *status, result);
    }
  }
  SolveByRayIntersection(mode, difference, settings, warm_start, observer, result);
}

template <class Set1, class Set2, class Observer>
DGD_FLATTEN ResultOf<Set1> GrowthDistance(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                          const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings,
                                          WarmStartOf<Set1>* warm_start, Observer&& observer) {
  ResultOf<Set1> result;
  if (HasSeparatingAxis(warm_start)) {
    const auto planes = PlanesAlong(warm_start->normal_1, set_1, pose_1, set_2, pose_2);
    if (SeparateByMoreThan(planes, settings.separation_limit)) {
      result.status = Status::kSeparated;
      result.iterations = 1;
      result.normal = planes.normal;
      result.separation = planes.separation;
      result.lower_bound = 1;  // The sets are apart.
      return result;
    }
  }
  Settings<typename Set1::Scalar> remaining = settings;
  // An observer gets bounds after each iteration, which portal refinement does not have.
  if constexpr (kHasPortalRefinement<Set1, Set2> && std::is_same_v<Observer, const NoObserver>) {
    if (SolveByPortal(set_1, pose_1, set_2, pose_2, settings, warm_start, nullptr, result, remaining)) return result;
  }
  result.iterations = settings.max_iterations - remaining.max_iterations;
  SolveInRayFrame(QueryMode::kDistance, set_1, pose_1, set_2, pose_2, remaining, warm_start, observer, result);
  // A support function gave a value that is not finite, or the sets are so small or large that their squares are none.
  if (!IsFinite(result)) result.status = Status::kInvalidInput;
  return result;
}

template <class Set1, class Set2>
CollisionResultOf<Set1> DetectCollision(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                        const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings,
                                        WarmStartOf<Set1>* warm_start) {
  using S = typename Set1::Scalar;
  using Point = VectorOf<typename Set1::Core>;
  CollisionResultOf<Set1> result;
  const bool is_cold = warm_start == nullptr || !HasNormal(*warm_start);
  Point normal_1;
  bool has_normal = false;
  if (is_cold) {
    has_normal = FindLineOfCenters(set_1, pose_1, set_2, pose_2, normal_1);
  } else if (HasSeparatingAxis(warm_start)) {
    normal_1 = warm_start->normal_1;
    has_normal = true;
  }
  SupportingPlanes<Set1> planes;
  if (has_normal) {
    planes = PlanesAlong(normal_1, set_1, pose_1, set_2, pose_2);
    if (ClassifyByPlane(planes, set_1, pose_1, set_2, pose_2, result)) {
      const bool are_apart = result.status == Status::kSeparated;
      if (warm_start != nullptr && (is_cold || !are_apart)) {
        *warm_start = {};
        if (are_apart) warm_start->normal_1 = normal_1.normalized();
      }
      if (!IsFinite(result)) result.status = Status::kInvalidInput;
      return result;
    }
  }
  Settings<S> remaining = settings;
  if constexpr (kHasPortalRefinement<Set1, Set2>) {
    const SupportingPlanes<Set1>* first = is_cold && has_normal ? &planes : nullptr;
    if (SolveByPortal(set_1, pose_1, set_2, pose_2, settings, warm_start, first, result, remaining)) return result;
  }
  const NoObserver observer;
  result.iterations = settings.max_iterations - remaining.max_iterations;
  SolveInRayFrame(QueryMode::kCollision, set_1, pose_1, set_2, pose_2, remaining, warm_start, observer, result);
  if (!IsFinite(result)) result.status = Status::kInvalidInput;  // A support function gave such a value, as above.
  return result;
}

}  // namespace dgd
