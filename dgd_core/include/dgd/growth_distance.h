// The door to the solver: growth distance, collision check, and the state that warm-starts either.
//
// The growth distance of two convex sets is the smallest common scale at which they touch, each scaled about its own
// centre: below 1 they overlap, at 1 they touch, above 1 they are apart (paper, Def. 3). The functions here are
// templates over the two sets, so that nothing virtual is called inside an iteration; a caller with many types of sets
// erases them once, around the call.
#pragma once

#include "dgd/query_types.h"

namespace dgd {

/// Growth distance of two sets in their poses; both of the same dimension and scalar.
/// @param pose_1, pose_2  Of the sets in the world.
/// @param warm_start      In and out; nullptr for a cold start that remembers nothing.
/// @param observer        Called with an Iterate after each iteration; not at all where none was needed: for coincident
///                        centres, and for sets that the last normal alone proves to be apart. Polytopes that are
///                        observed take more time: portal refinement has no bounds after each iteration.
/// Allocates nothing and does not throw. Alg. 3 of the paper.
template <class Set1, class Set2, class Observer = const NoObserver>
ResultOf<Set1> GrowthDistance(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                              const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings = {},
                              WarmStartOf<Set1>* warm_start = nullptr, Observer&& observer = NoObserver());

/// Whether two sets have a point in common; stops as soon as a bound crosses 1 (paper, Sec. III-D4). Parameters as for
/// GrowthDistance, whose warm start it shares. Of a deep overlap, a first check with a warm start takes longer than one
/// without: a common point is proven by less than a next check would begin from.
template <class Set1, class Set2>
CollisionResultOf<Set1> DetectCollision(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                        const PoseOf<Set1>& pose_2,
                                        const Settings<typename Set1::Scalar>& settings = {},
                                        WarmStartOf<Set1>* warm_start = nullptr);

}  // namespace dgd

#include "dgd/solver/query.h"
